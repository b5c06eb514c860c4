// SPDX-License-Identifier: BSD-2-Clause
// Contents that compare several minds, and contents that do not come from minds: files, bodies.
#include <algorithm>
#include <cctype>
#include <utility>

#include "debugger/watch.h"
#include "diagnostics/read_text.h"
#include "workbench/desk.h"

namespace soarbox::workbench {
namespace {

/// Position after the brace that closes the one at `open`; npos if none does. Braces in comments and quoted texts do
/// not count.
std::size_t EndOfRule(const std::string& text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if (c == '|' || c == '"') {
      for (++i; i < text.size() && text[i] != c; ++i)
        if (text[i] == '\\') ++i;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return i + 1;
    }
  }
  return std::string::npos;
}

/// The text of a rule from its command to its closing brace; empty if the text has no such rule.
std::string RuleIn(const std::string& text, std::string_view rule, int& line) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  for (std::size_t at = 0; (at = text.find(rule, at)) != std::string::npos; at += rule.size()) {
    const std::size_t behind = at + rule.size();
    if (behind < text.size() && !is_blank(text[behind]) && text[behind] != '(') continue;
    std::size_t open = at;
    while (open > 0 && is_blank(text[open - 1])) --open;
    if (open == 0 || text[--open] != '{') continue;
    std::size_t begin = open;
    while (begin > 0 && is_blank(text[begin - 1])) --begin;
    while (begin > 0 && std::isalpha(static_cast<unsigned char>(text[begin - 1]))) --begin;
    const std::size_t end = EndOfRule(text, open);
    if (end == std::string::npos) return {};
    line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    return text.substr(begin, end - begin);
  }
  return {};
}

}  // namespace

void Desk::FillBeside(Contents& contents, bool watches, bool minds) {
  contents.beside = beside_;
  if (contents.beside.empty() && !agent_.empty()) contents.beside.push_back(agent_);
  contents.watches.clear();
  contents.minds.clear();
  if (!watches && !minds) return;
  sim::Simulation* const world = common_.Looked();
  const auto inspect = [&](const std::string& agent) -> std::unique_ptr<explain::Inspector> {
    if (world != nullptr) return world->HasMind(agent) ? world->Inspect(agent) : nullptr;
    return recording_ != nullptr && HasReadOn() ? recorded_.Inspect(agent) : nullptr;
  };
  if (watches) {
    for (const std::string& what : watches_) contents.watches.push_back({what, {}});
  }
  for (const std::string& agent : contents.beside) {
    const std::unique_ptr<explain::Inspector> mind = inspect(agent);
    for (WatchRow& row : contents.watches) {
      WatchRow::Cell cell;
      cell.agent = agent;
      cell.tick = past_.shown_tick();
      if (mind != nullptr) {
        debugger::WatchValue value = debugger::LookAtWatch(*mind, row.what);
        cell.text = std::move(value.text);
        cell.is_error = value.is_error;
      } else {
        cell.text = "no mind to look into";
        cell.is_error = true;
      }
      WatchRow::Cell& before = watched_[{row.what, agent}];
      if (before.text == cell.text && !before.agent.empty()) {
        // A cell stays marked as new until the next tick.
        cell.is_new = before.is_new && before.tick == cell.tick;
        cell.tick = before.tick;
      } else {
        cell.is_new = !before.agent.empty();
      }
      before = cell;
      row.cells.push_back(std::move(cell));
    }
    if (!minds) continue;
    MindColumn& column = contents.minds.emplace_back();
    column.agent = agent;
    if (mind == nullptr) {
      column.note = past_.is_live() ? "It has no Soar mind." : past_.rebuilt().Note();
      continue;
    }
    column.stack = debugger::LookAtStack(*mind);
    column.operators = debugger::LookAtOperators(*mind);
    for (const debugger::AgentRow& row : contents.agents)
      if (row.name == agent) column.command = row.command;
  }
}

void Desk::FillRuleText(Contents& contents) {
  contents.rule_text.clear();
  if (!contents.rule || common_.Live() == nullptr) return;
  const explain::RuleFact& rule = contents.rule->rule;
  if (rule.type != "user" && rule.type != "default") return;
  for (const sim::WatchedFile& file : debugger::FilesOf(*common_.Live(), agent_)) {
    if (!file.is_rules) continue;
    int line = 0;
    std::string text = RuleIn(ReadText(file.file).value_or(""), rule.name, line);
    // The text of an unsaved edit that runs is in the open file.
    if (const debugger::Edit* const open = files_.FindRunning(file.file.string()))
      text = RuleIn(open->text(), rule.name, line);
    if (text.empty()) continue;
    contents.rule_text = std::move(text);
    contents.rule_file = file.file.string();
    contents.rule_line = line;
    return;
  }
}

void Desk::FillActivities(Contents& contents) {
  contents.activities.clear();
  if (!past_.is_live() || common_.Live() == nullptr) return;
  for (const world::AgentOverlay& agent : common_.Live()->Overlays({}).agents) {
    if (agent.doing.empty()) continue;
    contents.activities[agent.id] = agent.operator_name.empty() || agent.operator_name == agent.doing
                                        ? agent.doing
                                        : agent.operator_name + " \xc2\xb7 " + agent.doing;
  }
}

}  // namespace soarbox::workbench
