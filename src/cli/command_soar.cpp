// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/object_printer.h"
#include "cli/setting_store.h"
#include "cli/stack_printer.h"
#include "cli/summary.h"
#include "cli/version.h"
#include "kernel/imagery/imagery.h"

namespace soarbox::cli {
namespace {

using kernel::AgentSettings;
using kernel::Phase;

constexpr std::string_view kInvalidSoarSubcommand =
    "Invalid soar sub-command.  Use 'soar ?' to see a list of valid sub-commands and settings.";
constexpr std::string_view kInvalidCommand = "Invalid command.  Use 'soar ?' to see a list of valid settings.";
constexpr std::string_view kInvalidSoarArgument = "Invalid argument. Use 'soar ?' to see a list of valid settings.";

constexpr OptionSpec kStopOptions[] = {{'s', "self", OptionArgument::kNone, "stop this agent only"}};
constexpr OptionSpec kSwitchOptions[] = {
    {'e', "on"},
    {'e', "enable", OptionArgument::kNone, "switch on"},
    {'d', "off"},
    {'d', "disable", OptionArgument::kNone, "switch off"},
};
constexpr OptionSpec kStopPhaseOptions[] = {
    {'i', "input"}, {'p', "propose"}, {'d', "decide"}, {'a', "apply"}, {'o', "output"}, {'B', ""}, {'A', ""},
};

/// Reads the name of a phase; false for other words.
bool ReadPhase(std::string_view word, Phase& phase) {
  if (word == "input")
    phase = Phase::kInput;
  else if (word == "propose")
    phase = Phase::kPropose;
  else if (word == "decision")
    phase = Phase::kDecide;
  else if (word == "apply")
    phase = Phase::kApply;
  else if (word == "output")
    phase = Phase::kOutput;
  else
    return false;
  return true;
}

/// Parses the numeric prefix of an argument like Soar; without one it is 0.
std::int64_t LooseInteger(const std::string& text) {
  return ParseLeadingInteger(text).value_or(0);
}

/// A setting of `soar`. Settings without a field are stored as texts, or have a handler of their own.
struct SoarSetting {
  using Field = std::variant<std::monostate, bool AgentSettings::*, int AgentSettings::*,
                             std::uint32_t AgentSettings::*, std::int64_t AgentSettings::*>;
  std::string_view name;
  std::string_view help = {};  ///< For `soar ?`; empty: not listed there.
  Field field = {};
  std::string_view changed = {};  ///< Printed after a change to a number, which replaces {}, or to `on`.
  std::string_view off = {};      ///< Printed after a change to 0 or `off`; empty: `changed` is.
  std::int64_t minimum = 0;
  /// Maximum value that a stranger's files may set, so that a world always advances and does not depend on wall time.
  std::int64_t most_of_strangers = 2147483647;
};

constexpr SoarSetting kSettings[] = {
    {"keep-all-top-oprefs", "Keep all preferences for o-supported WMEs on top state",
     &AgentSettings::keep_all_top_o_preferences,
     "Soar will now always retain top level preferences for items that are already o-supported.\n",
     "Soar will now not retain top level preferences for items that are already o-supported.\n"},
    {"max-elaborations",
     "Maximum elaboration in a decision cycle",
     &AgentSettings::max_elaborations,
     "The maximum number of elaborations in a phase is now {}.\n",
     {},
     0,
     10'000},
    {"max-goal-depth",
     "Halt if goal stack reaches this depth",
     &AgentSettings::max_goal_depth,
     "The maximum goal depth is now {}.\n",
     {},
     1,
     1'000},
    {"max-nil-output-cycles",
     "Impasse after this many nil outputs (run --out)",
     &AgentSettings::max_nil_output_cycles,
     "The maximum number of decision cycles without output before interrupting is now {}.  (used with run --output)\n",
     {},
     1,
     1'000},
    {"max-dc-time", "Interrupt decision after this much time", &AgentSettings::max_decision_time_us,
     "Soar will now interrupt decisions after {} seconds.\n",
     "Soar will no longer interrupt based on how how long a decision takes. (default)\n", 0, 0},
    {"max-memory-usage",
     "Threshold for memory warning (see help)",
     {},
     "Soar will now interrupt execution if more than {} bytes of memory are used.  (This requires a special build of "
     "Soar.  See manual for more information.)\n",
     {},
     1},
    {"max-gp",
     "Maximum rules gp can generate",
     &AgentSettings::max_gp,
     "The maximum number of rules gp can generate is now {}.\n",
     {},
     1,
     100'000},
    {"max-partial-matches",
     {},
     &AgentSettings::max_partial_matches,
     "An agent that needs more than {} partial matches at a time is now halted.\n",
     {},
     1},
    {"stop-phase", "Phase before which Soar will stop"},
    {"tcl", "Allow Tcl code in commands"},
    {"timers", "Profile where Soar spends its time"},
    {"wait-snc", "Wait instead of impasse after state-no-change", &AgentSettings::wait_snc,
     "Soar will now wait instead of impassing when a state doesn't change.\n",
     "Soar will now impasse when a state doesn't change.\n"},
};

std::string Value(CommandCall& call, std::string_view name) {
  const AgentSettings& settings = call.agent().settings();
  if (name == "stop-phase") return std::string(PhaseName(settings.stop_phase));
  if (name == "like") return std::string(TextOf(settings.like));
  const SoarSetting& setting = *std::ranges::find(kSettings, name, &SoarSetting::name);
  return std::visit(
      [&](auto field) {
        if constexpr (std::is_same_v<decltype(field), std::monostate>) {
          return call.session.settings().Get("soar", name);
        } else if constexpr (std::is_same_v<decltype(field), bool AgentSettings::*>) {
          return std::string(OnOff(settings.*field));
        } else {
          return std::to_string(settings.*field);
        }
      },
      setting.field);
}

bool SoarHelp(CommandCall& call) {
  std::string text = "====== Soar General Commands and Settings =====\n";
  const auto row = [&](std::string_view name, std::string_view help) { text += fmt::format("{:<51}{}\n", name, help); };
  row("soar ?", "Print this help listing");
  row("soar init", "Re-initializes current state of Soar");
  row("soar stop [--self]", "Stop Soar execution");
  row("soar version", "Print version number of Soar");
  text += "----------------- Settings --------------------\n";
  for (const SoarSetting& setting : kSettings) {
    if (setting.help.empty()) continue;
    const std::string value = Value(call, setting.name);
    row(fmt::format("{:<{}}{}", setting.name, 47 - value.size(), value), setting.help);
  }
  text += "-----------------------------------------------\n\n";
  row("To change a setting:", "soar <setting> [<value>]");
  row("For a detailed explanation of these settings:", "help soar");
  call.Out(text);
  return true;
}

bool SoarOverview(CommandCall& call) {
  const kernel::Agent& agent = call.agent();
  std::uint32_t rules = 0;
  for (const auto type : {kernel::ProductionType::kUser, kernel::ProductionType::kDefault,
                          kernel::ProductionType::kChunk, kernel::ProductionType::kTemplate}) {
    rules += agent.CountProductions(type);
  }
  std::string stack;
  // Of a deep stack, only the first two and the last two states are shown.
  const std::size_t depth = agent.goals().depth();
  for (std::size_t level = 1; level <= depth; ++level) {
    if (depth > 4 && level == 3) {
      stack += " ... ";
      level = depth - 1;
    } else if (level > 1) {
      stack += ", ";
    }
    stack += SymbolText(agent, agent.goals().at(static_cast<kernel::GoalLevel>(level)).id);
  }
  Summary summary(55);
  summary.Rule('=');
  summary.Text(fmt::format("-                   Soar {} Summary                -\n", TextOf(agent.settings().like)))
      .Rule('=');
  const SettingStore& store = call.session.settings();
  const kernel::Imagery* const imagery = std::as_const(call.agent()).find_imagery();
  // In Soar's order; the last one is never enabled.
  const std::pair<const char*, bool> modules[] = {{"Core", true},
                                                  {"EBC", store.Get("chunk", "mode") != "never"},
                                                  {"SMem", store.IsOn("smem", "learning")},
                                                  {"EpMem", store.IsOn("epmem", "learning")},
                                                  {"SVS", imagery != nullptr && imagery->enabled()},
                                                  {"RL", store.IsOn("rl", "learning")},
                                                  {"WMA", store.IsOn("wma", "activation")},
                                                  {"SSA", false}};
  std::string enabled, disabled;
  for (const auto& [name, is_on] : modules) {
    std::string& list = is_on ? enabled : disabled;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  summary.Row("Enabled:", enabled).Row("Disabled:", disabled).Rule('-');
  summary.Row("Number of rules:", std::to_string(rules));
  summary.Row("Number of chunks:", std::to_string(agent.CountProductions(kernel::ProductionType::kChunk)));
  summary.Row("Decisions", std::to_string(agent.counters().decision_cycles + 1));
  summary.Row("Elaborations", std::to_string(agent.counters().elaborations)).Rule('-');
  summary.Row("State stack", stack);
  summary.Row("Current number of states", std::to_string(agent.goals().depth()));
  summary.Row("Next phase", PhaseName(agent.next_phase())).Rule('-');
  summary.Text("\nUse 'soar ?' for a command overview or 'help soar' for the manual page.");
  call.Out(summary.Take());
  return true;
}

bool InitAgent(CommandCall& call) {
  if (call.words.size() > 1) return call.Fail(kInvalidSoarArgument);
  if (call.interpreter.host().IsRunning(call.session)) {
    return call.Fail("The agent cannot be initialised while it runs.");
  }
  if (call.session.agent().out_of_memory()) {
    return call.Fail("The agent ran out of memory and is halted for good: destroy it and make a new one.");
  }
  {
    PrintStream::Uncaptured uncaptured(call.stream());
    call.interpreter.host().Reinitialize(call.session);
  }
  call.Out("\nAgent reinitialized.\n");
  return true;
}

bool Stop(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kStopOptions, parsed)) return false;
  if (!parsed.arguments.empty()) return call.Fail(kInvalidSoarArgument);
  call.interpreter.host().Stop(call.session, parsed.Has('s'));
  return true;
}

bool Version(CommandCall& call) {
  const std::string_view version = TextOf(call.agent().settings().like);
  call.Out(fmt::format("{}\nSoarbox {}", version, kSoarboxVersion));
  call.AddArgument("versionmajor", "int", "9");
  call.AddArgument("versionminor", "int", "6");
  call.AddArgument("versionmicro", "int", std::string(version.substr(version.rfind('.') + 1)));
  call.AddArgument("builddate", "string", "Soarbox " + std::string(kSoarboxVersion));
  return true;
}

/// Reads "on" or "off" from the words of a setting; nothing: no value. False: an invalid value.
bool ReadSwitch(CommandCall& call, std::optional<bool>& on) {
  ParsedWords parsed;
  if (!call.Parse(kSwitchOptions, parsed)) return false;
  if (parsed.Has('e')) on = true;
  if (parsed.Has('d')) on = false;
  if (parsed.arguments.empty()) return true;
  const std::string& word = parsed.arguments.front().text;
  if (word == "on")
    on = true;
  else if (word == "off")
    on = false;
  else
    return call.Fail(kInvalidSoarArgument);
  return true;
}

bool ShowSetting(CommandCall& call, std::string_view name) {
  call.Out(fmt::format("{} is {}\n", name, Value(call, name)));
  return true;
}

bool Like(CommandCall& call) {
  if (call.words.size() < 2) return ShowSetting(call, "like");
  const std::string& word = call.words[1].text;
  for (const kernel::SoarVersion version : {kernel::SoarVersion::k963, kernel::SoarVersion::k965}) {
    if (word != TextOf(version)) continue;
    call.agent().mutable_settings().like = version;
    call.session.UpdateTrace();
    call.Out(fmt::format("Rules that are loaded from now on behave as in Soar {}.\n", word));
    return true;
  }
  return call.Fail("The behaviour of this version is not known. Known versions are 9.6.3 and 9.6.5.");
}

/// Shows or changes the setting that words[0] names.
bool SwitchSetting(CommandCall& call) {
  const SoarSetting& setting = *std::ranges::find(kSettings, call.words[0].text, &SoarSetting::name);
  std::optional<bool> on;
  if (!ReadSwitch(call, on)) return false;
  if (!on) return ShowSetting(call, setting.name);
  call.agent().mutable_settings().*std::get<bool AgentSettings::*>(setting.field) = *on;
  call.Out(*on ? setting.changed : setting.off);
  return true;
}

bool NumberSetting(CommandCall& call) {
  const SoarSetting& setting = *std::ranges::find(kSettings, call.words[0].text, &SoarSetting::name);
  if (call.words.size() < 2) return ShowSetting(call, setting.name);
  const std::int64_t value = LooseInteger(call.words[1].text);
  if (value < setting.minimum || value > 2147483647) return call.Fail(kInvalidSoarArgument);
  if (call.interpreter.fence() != nullptr && value > setting.most_of_strangers)
    return call.Fail(
        fmt::format("The files of a scenario may set {} to {} at most.", setting.name, setting.most_of_strangers));
  std::visit(
      [&](auto field) {
        if constexpr (std::is_same_v<decltype(field), std::monostate>) {
          call.session.settings().Set("soar", setting.name, std::to_string(value));
        } else {
          AgentSettings& settings = call.agent().mutable_settings();
          settings.*field = static_cast<std::remove_reference_t<decltype(settings.*field)>>(value);
        }
      },
      setting.field);
  call.Out(value == 0 && !setting.off.empty() ? std::string(setting.off)
                                              : fmt::format(fmt::runtime(setting.changed), value));
  return true;
}

bool Timers(CommandCall& call) {
  std::optional<bool> on;
  if (!ReadSwitch(call, on)) return false;
  if (!on) return ShowSetting(call, "timers");
  call.session.settings().Set("soar", "timers", std::string(OnOff(*on)));
  call.session.times().Switch(*on);
  call.Out(*on ? "Timers are now enabled.\n" : "Timers are now disabled.\n");
  return true;
}

bool Tcl(CommandCall& call) {
  std::optional<bool> on;
  if (!ReadSwitch(call, on)) return false;
  if (on.value_or(false)) return call.Fail("Could not load library tclsoarlib: Library not found.");
  if (on) {
    call.Out("Tcl mode is already off.\n");
    return true;
  }
  return ShowSetting(call, "tcl");
}

bool StopPhase(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kStopPhaseOptions, parsed)) return false;
  std::string word;
  for (const ParsedOption& option : parsed.options) {
    switch (option.letter) {
      case 'i':
        word = "input";
        break;
      case 'p':
        word = "propose";
        break;
      case 'd':
        word = "decide";  // Soar does not accept "decision" as a phase; its name is "decide".
        break;
      case 'a':
        word = "apply";
        break;
      case 'o':
        word = "output";
        break;
      default:
        break;
    }
  }
  if (!parsed.arguments.empty()) word = parsed.arguments.front().text;
  AgentSettings& settings = call.agent().mutable_settings();
  if (word.empty()) {
    call.Out(fmt::format("Stop before {}", PhaseName(settings.stop_phase)));
  } else {
    Phase phase;
    if (!ReadPhase(word, phase)) return call.Fail(kInvalidSoarArgument);
    settings.stop_phase = phase;
    const std::string_view name = phase == Phase::kDecide ? "decide" : PhaseName(phase);
    call.Out(fmt::format("Soar will now stop before the {} phase.\n", name));
  }
  call.AddArgument("phase", "int", std::to_string(static_cast<int>(settings.stop_phase)));
  return true;
}

constexpr SubcommandInfo kSoarSubcommandList[] = {
    {"init", "", "starts the agent again: working memory is emptied, rules stay", {}, InitAgent},
    {"stop", "[--self]", "stops running agents", kStopOptions, Stop},
    {"version", "", "the version of Soar that this behaves like, and the version of Soarbox", {}, Version},
    {"like", "[9.6.3 | 9.6.5]", "the version of Soar that rules behave like where versions differ", {}, Like},
    {"keep-all-top-oprefs", "[on | off]", "keep every preference for o-supported elements of the top state",
     kSwitchOptions, SwitchSetting},
    {"max-elaborations", "[N]", "elaborations in a phase before it is ended", {}, NumberSetting},
    {"max-goal-depth", "[N]", "states on the stack before the run is ended", {}, NumberSetting},
    {"max-nil-output-cycles", "[N]", "decisions without output before run --output ends", {}, NumberSetting},
    {"max-dc-time", "[MICROSECONDS]", "time that a decision may take; 0: any", {}, NumberSetting},
    {"max-memory-usage",
     "[BYTES]",
     "kept for clients that set it; without effect (see max-partial-matches)",
     {},
     NumberSetting},
    {"max-gp", "[N]", "rules that one gp command may make", {}, NumberSetting},
    {"max-partial-matches",
     "[N]",
     "partial matches that rules may have at a time; an agent that needs more is halted for good",
     {},
     NumberSetting},
    {"stop-phase", "[PHASE]", "the phase before which runs by decisions stop", kStopPhaseOptions, StopPhase},
    {"tcl", "[on | off]", "Tcl in commands; never available", kSwitchOptions, Tcl},
    {"timers", "[on | off]", "keep times for stats", kSwitchOptions, Timers},
    {"wait-snc", "[on | off]", "wait instead of making a state when no operator is proposed", kSwitchOptions,
     SwitchSetting},
    {"?", "", "an overview of the settings", {}, SoarHelp},
    {"help", "", "an overview of the settings", {}, SoarHelp},
};

}  // namespace

const std::span<const SubcommandInfo> kSoarSubcommands = kSoarSubcommandList;

bool CommandSoar(CommandCall& call) {
  // The command shows the summary if it has no words, or more than a setting and its value.
  const auto plain =
      std::count_if(call.words.begin(), call.words.end(), [](const Word& word) { return !word.text.starts_with('-'); });
  if (plain < 2 || plain > 3) return SoarOverview(call);
  return RunSubcommand(call, {std::string(call.words.size() == 2 ? kInvalidSoarSubcommand : kInvalidCommand),
                              "Use 'soar ?' and 'help soar' to learn more about the soar command."});
}

}  // namespace soarbox::cli
