// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/console.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "debugger/rules.h"
#include "diagnostics/diagnostic.h"
#include "sim/live_edits.h"

namespace soarbox::debugger {
namespace {

constexpr std::string_view kCommands[] = {
    "alias",      "chunk",  "debug", "decide", "echo",  "epmem",   "excise",    "explain",     "fc",
    "gp",         "help",   "init",  "learn",  "load",  "matches", "output",    "preferences", "print",
    "production", "pwatch", "rl",    "run",    "save",  "smem",    "soar",      "source",      "sp",
    "srand",      "stats",  "stop",  "svs",    "trace", "unalias", "visualize", "watch",       "wm"};

bool IsBlank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : ", ") + words[i];
  return text;
}

}  // namespace

void Console::Keep(ConsoleLine::Kind kind, std::uint64_t tick, std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  while (!text.empty() && text.front() == '\n') text.remove_prefix(1);
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) lines_.push_back({kind, tick, std::move(line)});
  while (lines_.size() > kMostLines) lines_.pop_front();
}

bool Console::RunLua(sim::Simulation& simulation, const std::string& line) {
  constexpr std::string_view kOwn = "lua ", kSandbox = "lua-sandbox ";
  const bool is_of_sandbox = line.starts_with(kSandbox);
  const bool is_marked = is_of_sandbox || line.starts_with(kOwn);
  if (!is_marked && simulation.HasMind(agent_)) return false;
  const std::string text = is_marked ? line.substr((is_of_sandbox ? kSandbox : kOwn).size()) : line;
  Keep(ConsoleLine::Kind::kInput, simulation.tick(), line);
  simulation.Submit(sim::ScriptInput{is_of_sandbox ? std::string() : agent_, text});
  typed_lua_ = text;
  return true;
}

void Console::Run(sim::Simulation& simulation, const std::string& line) {
  if (IsBlank(line) || RunLua(simulation, line)) return;
  const std::uint64_t tick = simulation.tick();
  Keep(ConsoleLine::Kind::kInput, tick, line);
  const Result<std::string> answer = simulation.Command(agent_, line);
  own_.push_back(line);
  if (answer) {
    Keep(ConsoleLine::Kind::kOutput, tick, *answer);
    std::set<std::string> rules;
    for (const auto& [name, text] : sim::SplitRules(line).rules) rules.insert(name);
    for (const Diagnostic& slip : simulation.SlipsOf(agent_, rules))
      Keep(ConsoleLine::Kind::kHint, tick, slip.message + (slip.hint.empty() ? "" : ": " + slip.hint));
    return;
  }
  Keep(ConsoleLine::Kind::kError, tick, answer.error().message);
  if (!answer.error().hint.empty()) Keep(ConsoleLine::Kind::kHint, tick, answer.error().hint);
  if (answer.error().message.find("did you mean") != std::string::npos) return;
  if (const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(agent_)) {
    if (const std::vector<std::string> near = NearMisses(*mind, line); !near.empty())
      Keep(ConsoleLine::Kind::kHint, tick, "did you mean " + Joined(near) + "?");
  }
}

void Console::Refuse(const std::string& line, std::string_view why) {
  Keep(ConsoleLine::Kind::kInput, 0, line);
  Keep(ConsoleLine::Kind::kError, 0, why);
}

void Console::Add(const sim::EventList& events) {
  for (const sim::RunEvent& event : events) {
    const bool failed = event.kind == sim::EventKind::kDiagnostic && !event.news.empty();
    const bool is_of_lua = !typed_lua_.empty() && event.news == typed_lua_;
    if ((event.agent != agent_ && !is_of_lua) || (event.kind != sim::EventKind::kAnswer && !failed)) continue;
    if (!own_.empty() && own_.front() == event.news) {
      own_.pop_front();
      continue;
    }
    if (!is_of_lua) Keep(ConsoleLine::Kind::kInput, event.tick, event.news);
    if (failed) {
      Keep(ConsoleLine::Kind::kError, event.tick, event.diagnostic.message);
    } else {
      Keep(ConsoleLine::Kind::kOutput, event.tick, event.text);
    }
  }
}

Completion Complete(explain::Inspector& mind, std::string_view line) {
  Completion completion;
  const std::size_t blank = line.find_last_of(" \t;\n");
  completion.begin = blank == std::string_view::npos ? 0 : blank + 1;
  completion.words = mind.Complete(line);
  if (completion.words.empty() && !mind.TellsAll()) {
    const std::string_view word = line.substr(completion.begin);
    if (completion.begin == 0) {
      for (const std::string_view command : kCommands)
        if (command.starts_with(word)) completion.words.emplace_back(command);
    } else {
      for (const explain::RuleFact& rule : mind.Rules())
        if (rule.name.starts_with(word)) completion.words.push_back(rule.name);
    }
  }
  std::ranges::sort(completion.words);
  for (const std::string& word : completion.words) {
    if (&word == &completion.words.front()) completion.common = word;
    const auto differs = std::ranges::mismatch(completion.common, word);
    completion.common.erase(differs.in1, completion.common.end());
  }
  return completion;
}

std::vector<std::string> NearMisses(explain::Inspector& mind, std::string_view line) {
  std::vector<std::string> near;
  std::istringstream words{std::string(line)};
  std::string command, word;
  words >> command;
  const std::span<const std::string_view> commands(kCommands);
  if (std::ranges::find(commands, command) == commands.end()) {
    if (const std::string_view nearest = Suggest(command, std::vector(commands.begin(), commands.end()));
        !nearest.empty())
      near.emplace_back(nearest);
  }
  const std::vector<explain::RuleFact> rules = mind.Rules();
  constexpr std::size_t kShortest = 4;  // Shorter words are similar to too many others.
  while (words >> word) {
    const bool is_rule = std::ranges::any_of(rules, [&](const explain::RuleFact& rule) { return rule.name == word; });
    if (is_rule || word.size() < kShortest || word[0] == '-') continue;
    for (std::string& rule : NearRules(mind, word)) near.push_back(std::move(rule));
  }
  return near;
}

std::string ToText(const std::deque<ConsoleLine>& lines) {
  std::string text;
  for (const ConsoleLine& line : lines) {
    constexpr const char* kMarks[] = {"> ", "", "error: ", "note: "};
    text += kMarks[static_cast<int>(line.kind)] + line.text + "\n";
  }
  return text;
}

}  // namespace soarbox::debugger
