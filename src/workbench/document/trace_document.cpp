// SPDX-License-Identifier: BSD-2-Clause
// Trace: what happened, line by line, the newest first.
#include <algorithm>
#include <utility>

#include "debugger/file_place.h"
#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::TraceKind;
using debugger::TraceLine;

constexpr std::size_t kMostTraceLines = 300;

Role TraceRole(TraceKind kind) {
  switch (kind) {
    case TraceKind::kError:
      return Role::kBad;
    case TraceKind::kDecision:
      return Role::kGood;
    case TraceKind::kCommand:
      return Role::kNumber;
    case TraceKind::kInput:
      return Role::kWarn;
    case TraceKind::kPercept:
      return Role::kObject;
    case TraceKind::kRule:
      return Role::kName;
    case TraceKind::kEvent:
      return Role::kPlain;
    case TraceKind::kElement:
      break;
  }
  return Role::kQuiet;
}

/// Suggests operators and commands of the selected agent.
void AddWords(const Contents& contents, Field& field) {
  constexpr std::size_t kMostWords = 12, kMostLookedAt = 300;
  const auto add = [&](const std::string& word) {
    const bool is_new =
        std::ranges::find(field.options, word, &std::pair<std::string, std::string>::first) == field.options.end();
    if (is_new && field.options.size() < kMostWords) field.options.emplace_back(word, "");
  };
  const debugger::TimelineTrack* track =
      contents.timeline == nullptr ? nullptr : contents.timeline->Find(contents.agent);
  std::size_t seen = 0;
  for (std::size_t i = track == nullptr ? 0 : track->spans.size(); i > 0 && ++seen < kMostLookedAt; --i) {
    const auto& span = track->spans[i - 1];
    if (!span.is_state && !span.text.empty()) add("op:" + span.text);
  }
  for (const debugger::AgentRow& agent : contents.agents)
    if (!agent.command.empty()) add("command:" + agent.command);
  for (const char* about : {"rule:", "op:", "^"}) field.options.emplace_back(about, "");
}

Form FilterForm(const Contents& contents) {
  Form form{"trace", {TraceRequest{}}, {}, {}};
  // Each level includes those before it.
  constexpr std::pair<const char*, const char*> kLevels[] = {
      {"error", "errors"}, {"decision", "decisions"}, {"command", "commands"}, {"event", "events"},
      {"input", "input"},  {"percept", "percepts"},   {"rule", "rules"},       {"element", "elements"}};
  Field level{Field::Kind::kChoice, "level", "How much is shown: each level includes those before it"};
  for (const auto& [word, title] : kLevels) level.options.emplace_back(word, title);
  level.value = kLevels[static_cast<std::size_t>(contents.trace_filter.most)].first;
  form.fields.push_back(std::move(level));
  if (!contents.agent.empty()) {
    Field agent{Field::Kind::kCheck, "agent", "selected agent"};
    agent.options = {{"", ""}, {contents.agent, contents.agent}};
    agent.value = contents.trace_filter.agent;
    form.fields.push_back(std::move(agent));
  }
  Field text{Field::Kind::kSuggested, "text",
             "The line contains each word; rule:NAME, op:NAME, command:NAME and ^attribute: lines about these",
             "Search; rule:NAME op:NAME ^attribute", contents.trace_filter.text};
  AddWords(contents, text);
  form.fields.push_back(std::move(text));
  return form;
}

void AddLine(const Contents& contents, const TraceLine& line, std::size_t number, Table& table) {
  Span text{std::string(static_cast<std::size_t>(std::max(0, line.level - 1)) * 2, ' ') + line.text,
            TraceRole(line.kind)};
  if (line.kind == TraceKind::kError)
    if (const auto place = debugger::FindFilePlace(line.text)) {
      text = FileLink(contents, place->file, place->line, line.text);
      text.role = Role::kBad;
    }
  TableRow& row = table.Add(std::to_string(number), {TimeCell(line.tick),
                                                     TextCell(std::string(debugger::NameOf(line.kind)), Role::kQuiet),
                                                     {{Quiet(line.agent.empty() ? "world" : line.agent)}},
                                                     {{std::move(text)}}});
  row.arguments = {std::to_string(line.tick)};
  if (line.tick == contents.moment.shown_tick) row.cells[0].spans[0].role = Role::kWarn;
}

}  // namespace

Nodes TraceDocument(const Contents& contents) {
  if (contents.trace == nullptr || contents.trace->lines().empty())
    return {Empty("Nothing has happened yet.",
                  "Let the world run: what minds decide and say appears here, the newest first.")};
  Nodes nodes{FilterForm(contents)};
  Table table{"lines", {{"Time"}, {"Kind", false, true}, {"Agent"}, {"What happened", false, false, true}}};
  table.has_heads = false;
  table.press = RowAction{{SeekRequest{}}, "tick", 1};
  const auto add = [&](const auto& found) {
    for (std::size_t i = found.size(); i > 0 && table.rows.size() < kMostTraceLines; --i)
      if (found[i - 1]->tick <= contents.moment.shown_tick) AddLine(contents, *found[i - 1], i, table);
  };
  contents.trace_found != nullptr ? add(*contents.trace_found) : add(contents.trace->Find(contents.trace_filter));
  nodes.push_back(OrEmpty(std::move(table), "No line matches.", "Show more levels, or clear the search."));
  return nodes;
}

}  // namespace soarbox::workbench::document
