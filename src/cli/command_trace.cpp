// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/lookup.h"
#include "cli/session.h"
#include "cli/summary.h"

namespace soarbox::cli {
namespace {

constexpr auto kTraceOptional = OptionArgument::kOptional;

constexpr OptionSpec kTraceOptionList[] = {
    {'a', "wma", kTraceOptional, "activation of working memory"},
    {'A', "assertions", kTraceOptional, "instantiations and the match set"},
    {'b', "backtracing", kTraceOptional, "what learning traces back"},
    {'c', "chunks", kTraceOptional, "firings of learned rules"},
    {'C', "chunk-warnings", kTraceOptional, "problems met while learning"},
    {'d', "decisions", kTraceOptional, "operators selected and states made"},
    {'D', "default-productions", kTraceOptional, "firings of rules marked :default"},
    {'e', "epmem", kTraceOptional, "episodic memory"},
    {'f', "fullwmes", OptionArgument::kNone, "with firings, the complete elements that matched"},
    {'g', "gds", kTraceOptional, "states removed because an element of their goal dependency set changed"},
    {'G', "gds-wmes", kTraceOptional, "elements that are added to a state's goal dependency set"},
    {'i', "indifferent-selection", kTraceOptional, "values of indifferent operators"},
    {'j', "justifications", kTraceOptional, "firings of justifications"},
    {'L', "learning", OptionArgument::kRequired, "learned rules: noprint, print, fullprint or 0 to 2"},
    {'l', "level", OptionArgument::kRequired, "a level from 0 to 5"},
    {'N', "none", OptionArgument::kNone, "nothing at all"},
    {'n', "nowmes", OptionArgument::kNone, "with firings, no elements"},
    {'o', "consistency", kTraceOptional, "operators and states removed because they no longer fit"},
    {'p', "phases", kTraceOptional, "phases of the decision cycle"},
    {'P', "productions", kTraceOptional, "firings of all kinds of rules"},
    {'r', "preferences", kTraceOptional, "preferences made and retracted"},
    {'R', "rl", kTraceOptional, "updates of reinforcement learning"},
    {'s', "smem", kTraceOptional, "semantic memory"},
    {'t', "timetags", OptionArgument::kNone, "with firings, the time tags of the elements that matched"},
    {'T', "template", kTraceOptional, "matches of rules marked :template"},
    {'u', "user-productions", kTraceOptional, "firings of ordinary rules"},
    {'w', "wmes", kTraceOptional, "elements added to and removed from working memory"},
    {'W', "waterfall", kTraceOptional, "firings that wait for a higher state"},
};

const TraceFlagInfo* FlagOfLetter(char letter) {
  for (const TraceFlagInfo& info : TraceSettings::Infos()) {
    if (info.letter == letter) return &info;
  }
  return nullptr;
}

const TraceFlagInfo& InfoOf(TraceFlag flag) {
  return TraceSettings::Infos()[static_cast<std::size_t>(flag)];
}

std::string Rule(std::string_view title) {
  const std::size_t free = 60 - title.size() - 2;
  return std::string(free / 2, '-') + " " + std::string(title) + " " + std::string(free - free / 2, '-') + "\n";
}

constexpr const char* kLearningNames[] = {"none (0)", "print (1)", "fullprint (2)"};

std::string Table(const TraceSettings& trace) {
  std::string text = std::string(60, '=') + "\n" + std::string(20, ' ') + "Soar Trace Messages" + std::string(21, ' ') +
                     "\n" + std::string(60, '=') + "\n";
  const auto row = [&](std::string_view title, std::string_view value, std::string_view options) {
    text += fmt::format("{:<{}}{}     {}\n", title, 60 - value.size(), value, options);
  };
  const auto flag = [&](TraceFlag which) {
    const TraceFlagInfo& info = InfoOf(which);
    row(info.title, OnOff(trace.On(which)), fmt::format("-{}, --{}", info.letter, info.option));
  };
  using enum TraceFlag;
  text += Rule("Level 1");
  flag(kDecisions);
  text += Rule("Level 2");
  for (const TraceFlag which : {kPhases, kChunkWarnings, kGds, kConsistency}) flag(which);
  text += Rule("Level 3: Rule firings");
  for (const TraceFlag which : {kDefaultRules, kUserRules, kChunks, kJustifications, kTemplates, kWaterfall})
    flag(which);
  text += Rule("Level 4");
  flag(kWmes);
  text += Rule("Level 5");
  flag(kPreferences);
  text += " \n" + Rule("Additional General Trace Messages");
  for (const TraceFlag which : {kAssertions, kGdsWmes, kIndifferent, kRl}) flag(which);
  constexpr const char* kDetails[] = {"none", "timetag", "full detail"};
  row("WME Detail Level", kDetails[static_cast<int>(trace.wme_detail())], "--nowmes, --timetags, --fullwmes");
  text += " \n" + Rule("Additional Chunking Trace Messages");
  flag(kBacktracing);
  row("Rules learned (verbosity level)", kLearningNames[trace.learning()], "-L, --learning [0-2]");
  text += " \n" + Rule("Additional Memory System Trace Messages");
  for (const TraceFlag which : {kEpmem, kSmem, kWma}) flag(which);
  return text;
}

void AddStructured(CommandCall& call, const TraceSettings& trace) {
  for (const TraceFlagInfo& info : TraceSettings::Infos()) {
    if (!info.argument.empty()) {
      call.AddArgument(std::string(info.argument), "boolean", trace.On(info.flag) ? "true" : "false");
    }
  }
  call.AddArgument("watchwmedetail", "int", std::to_string(static_cast<int>(trace.wme_detail())));
  call.AddArgument("watchlearning", "int", std::to_string(trace.learning()));
}

bool SetLevel(CommandCall& call, const std::string& word) {
  const auto level = ParseLeadingInteger(word);
  if (!level) return call.Fail("Integer argument expected.");
  if (*level < 0 || *level > TraceSettings::kMaxLevel) {
    call.Out("Expected trace level from 0 to 5.\n\n");
    return call.FailPrinted();
  }
  call.session.trace().SetLevel(static_cast<int>(*level));
  call.session.UpdateTrace();
  constexpr const char* kMessages[] = {
      "Trace level 0 enabled:  All trace messages disabled.\n",
      "Trace level 1 enabled:  Decision cycles, state creation and operator selection\n",
      ("Trace level 2 enabled:  All phases, state removals caused by operator selection\n"
       "                        or a GDS violation, and any learning issues detected\n"),
      "Trace level 3 enabled:  All rule firings\n",
      "Trace level 4 enabled:  Working memory element additions and removals\n",
      "Trace level 5 enabled: Preferences\n",
  };
  if (*level == 0) call.Out(kMessages[0]);
  for (std::int64_t i = *level; i >= 1; --i) call.Out(kMessages[i]);
  call.Out("\nFor a full list of trace options, use 'trace' (no arguments)\n");
  return true;
}

/// The changes that the options request; messages are printed in a fixed order.
struct Changes {
  bool changed[kTraceFlagCount] = {};
  bool learning = false;
  bool detail = false;
};

void Report(CommandCall& call, const Changes& changes) {
  const TraceSettings& trace = call.session.trace();
  for (const TraceFlagInfo& info : TraceSettings::Infos()) {
    if (!changes.changed[static_cast<int>(info.flag)]) continue;
    call.Out(fmt::format("{}{}.\n", trace.On(info.flag) ? "Now printing " : "Will not print ", info.message));
  }
  if (changes.learning) {
    constexpr const char* kMessages[] = {
        "Will not print any information about chunks or justifications learned.\n",
        "Now printing the names of chunks and justifications that are learned and any chunking issues detected.\n",
        "Now printing the full chunks and justifications that are learned and any chunking issues detected.\n",
    };
    call.Out(kMessages[trace.learning()]);
  }
  if (changes.detail) {
    constexpr const char* kMessages[] = {
        "Will not print working memory element details.\n",
        "Will only print working memory element timetags.\n",
        "Will print the full working memory element.\n",
    };
    call.Out(kMessages[static_cast<int>(trace.wme_detail())]);
  }
  call.Out("\n");
}

bool SetLearning(CommandCall& call, const std::string& word, Changes& changes) {
  constexpr const char* kWords[] = {"noprint", "print", "fullprint"};
  for (int i = 0; i < 3; ++i) {
    if (word == kWords[i] || word == std::to_string(i)) {
      call.session.trace().SetLearning(i);
      changes.learning = true;
      return true;
    }
  }
  call.Out("Invalid learn setting, expected noprint, print, fullprint, or 0-2. Got: " + word + "\n\n");
  return call.FailPrinted();
}

bool ApplyOption(CommandCall& call, const ParsedOption& option, Changes& changes) {
  TraceSettings& trace = call.session.trace();
  bool on = true;
  if (option.letter == 'l') return true;
  if (option.argument && option.letter != 'L') {
    if (*option.argument != "remove" && *option.argument != "0") {
      call.Out("Invalid argument, expected remove or 0. Got: " + *option.argument + "\n\n");
      return call.FailPrinted();
    }
    on = false;
  }
  const auto set = [&](TraceFlag flag) {
    trace.Set(flag, on);
    changes.changed[static_cast<int>(flag)] = true;
  };
  switch (option.letter) {
    case 'L':
      return SetLearning(call, *option.argument, changes);
    case 'f':
    case 'n':
    case 't':
      trace.SetWmeDetail(option.letter == 'f'   ? WmeDetail::kFull
                         : option.letter == 't' ? WmeDetail::kTimetags
                                                : WmeDetail::kNone);
      changes.detail = true;
      return true;
    case 'N':
      trace.SetLevel(0);
      for (bool& changed : changes.changed) changed = true;
      changes.learning = changes.detail = true;
      return true;
    case 'P':
      for (const TraceFlag flag :
           {TraceFlag::kDefaultRules, TraceFlag::kUserRules, TraceFlag::kChunks, TraceFlag::kJustifications}) {
        set(flag);
      }
      return true;
    default:
      break;
  }
  if (const TraceFlagInfo* info = FlagOfLetter(option.letter)) set(info->flag);
  return true;
}

}  // namespace

const std::span<const OptionSpec> kTraceOptions = kTraceOptionList;

bool CommandTrace(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kTraceOptions, parsed)) return false;
  if (parsed.options.empty() && parsed.arguments.empty()) {
    call.Out(Table(call.session.trace()));
    AddStructured(call, call.session.trace());
    return true;
  }
  if (parsed.arguments.size() > 1) return call.Fail("Only non option argument allowed is watch level.");
  Changes changes;
  for (const ParsedOption& option : parsed.options) {
    if (!ApplyOption(call, option, changes)) {
      call.session.UpdateTrace();
      return false;
    }
  }
  // A level is applied last and overrides the options. Only level 0 changes the detail of elements and learned rules.
  const auto level = parsed.Argument('l');
  if (level && !ParseLeadingInteger(*level)) return call.Fail("Syntax: trace [options]");
  if (level && !SetLevel(call, *level)) return false;
  if (!parsed.arguments.empty()) return SetLevel(call, parsed.arguments.front().text);
  if (level) return true;
  call.session.UpdateTrace();
  Report(call, changes);
  return true;
}

}  // namespace soarbox::cli
