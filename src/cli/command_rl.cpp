// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <deque>
#include <utility>

#include "cli/command.h"
#include "cli/lookup.h"
#include "cli/reinforcement_settings.h"
#include "cli/session.h"
#include "cli/setting_store.h"
#include "kernel/learn/choice_graph.h"
#include "kernel/learn/reinforcement.h"

namespace soarbox::cli {
namespace {

using kernel::ChoiceGraph;
using kernel::GoalLevel;

constexpr OptionSpec kRlTable[] = {
    {'g', "get", OptionArgument::kRequired, "show a setting"},
    {'s', "set", OptionArgument::kRequired, "change a setting"},
    {'S', "stats", OptionArgument::kOptional, "rewards, or the figure with this name"},
    {'t', "trace", OptionArgument::kOptional, "the choices so far as a graph: print, clear or init, of one level"},
};

void Group(CommandCall& call, std::string_view title, std::initializer_list<std::string_view> names) {
  call.Out(fmt::format("\n{}\n{}\n", title, std::string(title.size(), '-')));
  for (const std::string_view name : names) {
    call.Out(fmt::format("{}: {}\n", name, call.session.settings().Get("rl", name)));
  }
}

bool RlOverview(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  call.Out(fmt::format("\nSoar-RL learning: {}\ntemporal-extension: {}\n", store.Get("rl", "learning"),
                       store.Get("rl", "temporal-extension")));
  Group(call, "Discount", {"discount-rate"});
  Group(call, "Learning", {"learning-policy", "learning-rate", "hrl-discount", "step-size-parameter"});
  Group(call, "Eligibility Traces", {"eligibility-trace-decay-rate", "eligibility-trace-tolerance"});
  Group(call, "Experimental", {"chunk-stop", "decay-mode", "meta", "meta-learning-rate", "update-log-path"});
  call.Out("\n");
  for (const char* name : {"apoptosis", "apoptosis-decay", "apoptosis-thresh"}) {
    call.Out(fmt::format("{}: {}\n", name, store.Get("rl", name)));
  }
  call.Out(fmt::format("\ntrace: {}\n\n", store.Get("rl", "trace")));
  return true;
}

bool Get(CommandCall& call, const std::string& name, const ParsedWords& parsed) {
  if (!parsed.arguments.empty()) return call.Fail("Too many arguments.");
  if (SettingStore::Find("rl", name) == nullptr) return call.Fail("Invalid setting.");
  call.Out(call.session.settings().Get("rl", name));
  return true;
}

bool Set(CommandCall& call, const std::string& name, const ParsedWords& parsed) {
  if (parsed.arguments.empty()) return call.Fail("Too few arguments.");
  // A path may contain blanks.
  if (parsed.arguments.size() > 1 && name != "update-log-path") return call.Fail("Too many arguments.");
  std::string value;
  for (const Word& word : parsed.arguments) value += (value.empty() ? "" : " ") + word.text;
  if (name == "update-log-path" && !call.session.SetReinforcementLog(value)) {
    return call.Fail("Cannot write to '" + value + "': updates are not logged there.");
  }
  SettingStore& store = call.session.settings();
  switch (SetReinforcement(store, name, value)) {
    case RlSetResult::kUnknown:
      return call.Fail("Invalid setting.");
    case RlSetResult::kInvalid:
      return call.Fail("Invalid value for setting.");
    case RlSetResult::kLocked:
      return call.Fail("Failed to set value.");
    case RlSetResult::kOk:
      break;
  }
  call.agent().SetReinforcement(ReinforcementSettings(store));
  call.agent().mutable_settings().ignore_numbers_of_duplicates = store.IsOn("rl", "chunk-stop");
  return true;
}

bool Statistics(CommandCall& call, const std::optional<std::string>& name) {
  const kernel::RlStatistics& figures = call.agent().reward();
  // Soar 9.6.3 never counts the errors of updates; `trace --rl` shows the changes.
  const std::pair<std::string_view, std::pair<std::string_view, double>> kFigures[] = {
      {"update-error", {"Error from last update", 0}},
      {"total-reward", {"Total reward in last cycle", figures.reward}},
      {"global-reward", {"Global reward since init", figures.total_reward}},
  };
  for (const auto& [key, figure] : kFigures) {
    if (!name) call.Out(fmt::format("{}: {:.16g}\n", figure.first, figure.second));
    if (!name || *name != key) continue;
    call.Out(fmt::format("{:.16g}", figure.second));
    return true;
  }
  return !name || call.Fail("Invalid statistic.");
}

/// The tree of the choices of a level as a Graphviz graph, in breadth-first order.
std::string GraphText(const ChoiceGraph::Node& root) {
  std::string text = "digraph RL_Trace {\n";
  std::deque<std::pair<const ChoiceGraph::Node*, std::size_t>> open{{&root, 0}};
  std::size_t count = 0;
  for (; !open.empty(); open.pop_front()) {
    const auto [node, number] = open.front();
    for (const auto& [look, branch] : node->branches) {
      text += fmt::format("  {}\n  {} -> {} [label=\"", count + 1, number, count + 1);
      for (const std::string& line : look) text += line + "\\n";
      text += branch.probability ? fmt::format("{:g}", *branch.probability) : "-";
      text += fmt::format(" ({})\"];\n", branch.begun);
      ++count;
      if (branch.next != nullptr) open.emplace_back(branch.next.get(), count);
    }
  }
  return text + "}\n";
}

bool Trace(CommandCall& call, const std::optional<std::string>& word, const ParsedWords& parsed) {
  const bool has_command = word && (*word == "clear" || *word == "init" || *word == "print");
  const std::string level_word = !parsed.arguments.empty() ? parsed.arguments.front().text
                                 : word && !has_command    ? *word
                                                           : std::string();
  if (word && !has_command && !parsed.arguments.empty()) return call.Fail("Invalid arguments to rl -t.");
  GoalLevel level = 0;
  if (!level_word.empty()) {
    const auto number = ParseLeadingInteger(level_word);
    if (!number || *number < 1 || *number > 0xFFFF) {
      const std::string which = has_command && *word != "print" ? " " + *word : "";
      return call.Fail("Invalid RL goal level for rl -t" + which + ".");
    }
    level = static_cast<GoalLevel>(*number);
  }
  ChoiceGraph& graph = call.agent().choice_graph();
  if (word && *word == "clear") {
    level == 0 ? graph.ClearAll() : graph.Clear(level);
  } else if (word && *word == "init") {
    level == 0 ? graph.BeginAll() : graph.BeginAt(level);
  } else {
    if (level == 0) level = 1;
    call.Out(fmt::format("# RL Trace, Goal Level {}:\n", level));
    if (const ChoiceGraph::Node* const root = graph.Root(level)) call.Out(GraphText(*root));
  }
  return true;
}

}  // namespace

const std::span<const OptionSpec> kRlOptions = kRlTable;

bool CommandRl(CommandCall& call) {
  if (call.words.size() == 2 && (call.words[1].text == "?" || call.words[1].text == "help")) {
    return call.Fail("Invalid syntax; 'rl' shows the settings.");
  }
  if (const std::string& last = call.words.back().text;
      last == "-g" || last == "--get" || last == "-s" || last == "--set") {
    return call.Fail("Too few arguments.");
  }
  ParsedWords parsed;
  if (!call.Parse(kRlTable, parsed)) return false;
  if (parsed.options.empty()) return parsed.arguments.empty() ? RlOverview(call) : call.Fail("Invalid syntax.");
  if (const auto name = parsed.Argument('g')) return Get(call, *name, parsed);
  if (const auto name = parsed.Argument('s')) return Set(call, *name, parsed);
  if (parsed.Has('t')) return Trace(call, parsed.Argument('t'), parsed);
  if (!parsed.arguments.empty()) return call.Fail("Unneccessary argument to rl -S");
  return Statistics(call, parsed.Argument('S'));
}

}  // namespace soarbox::cli
