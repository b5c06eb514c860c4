// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/session.h"
#include "cli/setting_store.h"
#include "cli/summary.h"

namespace soarbox::cli {
namespace {

using SetResult = SettingStore::SetResult;
constexpr auto kRequired = OptionArgument::kRequired;
constexpr auto kOptional = OptionArgument::kOptional;

constexpr OptionSpec kRlTable[] = {
    {'g', "get", kRequired, "show a setting"},
    {'s', "set", kRequired, "change a setting"},
    {'S', "stats", kOptional, "figures"},
    {'t', "trace", kOptional, "the history of choices as a graph"},
};

constexpr OptionSpec kSmemTable[] = {
    {'a', "add", kRequired, "add objects"},
    {'b', "backup", kRequired, "copy the database"},
    {'c', "clear", OptionArgument::kNone, "forget everything"},
    {'e', "enable", OptionArgument::kNone, "switch on"},
    {'e', "on"},
    {'d', "disable", OptionArgument::kNone, "switch off"},
    {'d', "off"},
    {'g', "get", kRequired, "show a setting"},
    {'h', "history", kRequired, "when an object was used"},
    {'i', "init", OptionArgument::kNone, "open the database again"},
    {'P', "precalculate", OptionArgument::kNone, "prepare spreading"},
    {'q', "query", kRequired, "find objects"},
    {'r', "remove", kRequired, "remove objects or their elements"},
    {'s', "set", kRequired, "change a setting"},
    {'S', "stats", kOptional, "figures"},
    {'t', "timers", kOptional, "times"},
    {'x', "export", kRequired, "write everything as commands"},
};

constexpr OptionSpec kEpmemTable[] = {
    {'b', "backup", kRequired, "copy the database"},
    {'c', "close", OptionArgument::kNone, "close the database"},
    {'e', "enable", OptionArgument::kNone, "switch on"},
    {'e', "on"},
    {'d', "disable", OptionArgument::kNone, "switch off"},
    {'d', "off"},
    {'g', "get", kRequired, "show a setting"},
    {'i', "init", OptionArgument::kNone, "forget all episodes"},
    {'p', "print", kRequired, "show an episode"},
    {'s', "set", kRequired, "change a setting"},
    {'S', "stats", kOptional, "figures"},
    {'t', "timers", kOptional, "times"},
    {'v', "viz", kRequired, "an episode as a graph"},
};

/// A part of Soar that this build has the settings of, and nothing else.
struct Part {
  std::string_view group;
  std::string_view title;
  std::string_view unknown_get, unknown_set, invalid;
  bool silent;  ///< Setting answers nothing; showing gives the value alone.
};

bool Get(CommandCall& call, const Part& part, const std::string& name) {
  if (!SettingStore::Find(part.group, name)) return call.Fail(part.unknown_get);
  const std::string value = call.session.settings().Get(part.group, name);
  call.Out(part.silent ? value : fmt::format("{} is {}\n", name, value));
  return true;
}

/// Switching a missing part on is kept as a setting, so that agents' files load; a hint says that nothing follows.
void HintIfSwitchedOn(CommandCall& call, const Part& part) {
  if (!call.session.settings().IsOn(part.group, "learning")) return;
  call.Hint(fmt::format("{} is not available in this build", part.title), "the setting is kept and has no effect");
}

bool Set(CommandCall& call, const Part& part, const ParsedWords& parsed) {
  const std::string name = *parsed.Argument('s');
  std::string value;
  for (const Word& word : parsed.arguments) value += (value.empty() ? "" : " ") + word.text;
  if (parsed.arguments.empty()) return call.Fail("Invalid arguments for set: a setting and its value are expected.");
  SettingStore& store = call.session.settings();
  if (part.group == "epmem" && name == "exclusions") {
    call.Out("exclusions is now " + value + "\n");
    return store.Set(part.group, name, value) == SetResult::kOk;
  }
  switch (store.Set(part.group, name, value)) {
    case SetResult::kUnknown:
      return call.Fail(part.unknown_set);
    case SetResult::kInvalid:
      return call.Fail(part.invalid);
    case SetResult::kOk:
      break;
  }
  if (name == "learning") HintIfSwitchedOn(call, part);
  if (part.group == "rl" && name == "chunk-stop") {
    call.agent().mutable_settings().ignore_numbers_of_duplicates = store.IsOn("rl", "chunk-stop");
  }
  if (!part.silent) call.Out(fmt::format("{} is now {}\n", name, value));
  return true;
}

bool NotAvailable(CommandCall& call, const Part& part) {
  return call.Fail(std::string(part.title) + " is not available in this build.");
}

bool Switch(CommandCall& call, const Part& part, bool on) {
  call.session.settings().Set(part.group, "learning", std::string(OnOff(on)));
  HintIfSwitchedOn(call, part);
  call.Out(fmt::format("{} {}.\n", part.title, on ? "enabled" : "disabled"));
  return true;
}

void Group(CommandCall& call, std::string_view title, std::string_view group,
           std::initializer_list<std::string_view> names) {
  call.Out(fmt::format("\n{}\n{}\n", title, std::string(title.size(), '-')));
  for (const std::string_view name : names) {
    call.Out(fmt::format("{}: {}\n", name, call.session.settings().Get(group, name)));
  }
}

bool RlOverview(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  call.Out(fmt::format("\nSoar-RL learning: {}\ntemporal-extension: {}\n", store.Get("rl", "learning"),
                       store.Get("rl", "temporal-extension")));
  Group(call, "Discount", "rl", {"discount-rate"});
  Group(call, "Learning", "rl", {"learning-policy", "learning-rate", "hrl-discount", "step-size-parameter"});
  Group(call, "Eligibility Traces", "rl", {"eligibility-trace-decay-rate", "eligibility-trace-tolerance"});
  Group(call, "Experimental", "rl", {"chunk-stop", "decay-mode", "meta", "meta-learning-rate", "update-log-path"});
  call.Out("\n");
  for (const char* name : {"apoptosis", "apoptosis-decay", "apoptosis-thresh"}) {
    call.Out(fmt::format("{}: {}\n", name, store.Get("rl", name)));
  }
  call.Out(fmt::format("\ntrace: {}\n\n", store.Get("rl", "trace")));
  return true;
}

void Heading(Summary& summary, std::string_view title, int width) {
  const int free = width - static_cast<int>(title.size()) - 2;
  const int left = free - free / 2;
  summary.Text(std::string(static_cast<std::size_t>(left), '-') + " " + std::string(title) + " " +
               std::string(static_cast<std::size_t>(free - left), '-') + "\n");
}

bool EpmemOverview(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  Summary summary(40);
  const auto rows = [&](std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) summary.Row(std::string(name) + ":", store.Get("epmem", name));
  };
  summary.Rule('=').Text("        Episodic Memory Settings        \n").Rule('=');
  rows({"learning"});
  Heading(summary, "Encoding", 40);
  rows({"phase", "trigger", "force", "exclusions"});
  Heading(summary, "Storage", 40);
  rows({"database", "append", "path", "lazy-commit"});
  Heading(summary, "Retrieval", 40);
  rows({"balance", "graph-match", "graph-match-ordering"});
  Heading(summary, "Performance", 40);
  rows({"page-size", "cache-size", "optimization", "timers"});
  Heading(summary, "Experimental", 40);
  rows({"merge"});
  call.Out(summary.Take() + "\n");
  return true;
}

bool SmemOverview(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  Summary summary(52);
  const bool in_memory = store.Get("smem", "database") == "memory";
  const auto row = [&](std::string_view name, std::string_view value, std::string_view after) {
    summary.Text(fmt::format("{:<{}}{}   {}\n", name, 52 - value.size(), value, after));
  };
  summary.Rule('=').Text("              Semantic Memory Summary\n").Rule('=');
  row("Enabled", store.Get("smem", "learning"), "");
  row("Storage", in_memory ? "Memory" : "File",
      store.IsOn("smem", "append") ? "(append after init)" : "(overwrite after init)");
  summary.Rule('-');
  row("Nodes", "0", "");
  row("Edges", "0", "");
  row("Memory Usage", "0", "bytes");
  summary.Rule('-');
  summary.Text("For a full list of smem's sub-commands and settings:  smem ?");
  call.Out(summary.Take());
  return true;
}

/// All settings of a part, for its `?`.
bool ListSettings(CommandCall& call, const Part& part, std::span<const OptionSpec> options) {
  call.Out(fmt::format("{}: settings\n", part.title));
  for (const SettingInfo& info : SettingStore::All()) {
    if (info.group != part.group) continue;
    call.Out(fmt::format("  {:<32} {:<12} {}\n", info.name, call.session.settings().Get(part.group, info.name),
                         info.kind == SettingKind::kSwitch ? "on off" : info.choices));
  }
  call.Out("Options\n");
  for (const OptionSpec& option : options) {
    if (!option.help.empty()) call.Out(fmt::format("  -{}, --{:<26} {}\n", option.letter, option.name, option.help));
  }
  return true;
}

/// What the three commands have in common. `overview` answers the bare command.
bool Run(CommandCall& call, const Part& part, std::span<const OptionSpec> options,
         bool (*overview)(CommandCall& call)) {
  if (call.words.size() == 2 && (call.words[1].text == "?" || call.words[1].text == "help")) {
    if (part.group == "rl") return call.Fail("Invalid syntax; 'rl' shows the settings.");
    return ListSettings(call, part, options);
  }
  ParsedWords parsed;
  if (!call.Parse(options, parsed)) return false;
  if (parsed.options.empty()) {
    return parsed.arguments.empty() ? overview(call) : call.Fail("Invalid syntax.");
  }
  if (const auto name = parsed.Argument('g')) return Get(call, part, *name);
  if (parsed.Has('s')) return Set(call, part, parsed);
  if (part.group != "rl" && parsed.Has('e')) return Switch(call, part, true);
  if (part.group != "rl" && parsed.Has('d')) return Switch(call, part, false);
  return NotAvailable(call, part);
}

}  // namespace

const std::span<const OptionSpec> kRlOptions = kRlTable;
const std::span<const OptionSpec> kSmemOptions = kSmemTable;
const std::span<const OptionSpec> kEpmemOptions = kEpmemTable;

bool CommandRl(CommandCall& call) {
  constexpr Part kPart{
      "rl", "Reinforcement learning", "Invalid setting.", "Invalid setting.", "Invalid value for setting.", true};
  return Run(call, kPart, kRlTable, RlOverview);
}

bool CommandSmem(CommandCall& call) {
  constexpr Part kPart{"smem",
                       "Semantic memory",
                       "Invalid semantic memory parameter.  Use 'help smem' to see list of valid settings.",
                       "Invalid SMem parameter.",
                       "Invalid setting for SMem parameter.",
                       false};
  return Run(call, kPart, kSmemTable, SmemOverview);
}

bool CommandEpmem(CommandCall& call) {
  constexpr Part kPart{"epmem",
                       "Episodic memory",
                       "Invalid epmem parameter.",
                       "Invalid epmem parameter.",
                       "Invalid setting for epmem parameter.",
                       false};
  return Run(call, kPart, kEpmemTable, EpmemOverview);
}

}  // namespace soarbox::cli
