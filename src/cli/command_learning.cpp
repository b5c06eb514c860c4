// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/command.h"
#include "cli/session.h"
#include "cli/setting_store.h"
#include "cli/settings_command.h"
#include "cli/summary.h"

namespace soarbox::cli {
namespace {

/// Learning is a later part of the kernel: the modes can be set, so that agents' files load, and rules say so.
bool SetMode(CommandCall& call, const std::string& mode) {
  call.session.settings().Set("chunk", "mode", mode);
  if (mode != "never") {
    call.Hint("rules are not learned in this build", "the setting is kept, results of substates are still supported");
  }
  return true;
}

std::string YesNo(bool yes) {
  return yes ? "Yes" : "No";
}

void Overview(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  const std::string mode = store.Get("chunk", "mode");
  Summary summary(55);
  summary.Rule('=').Text("           Explanation-Based Chunking Summary\n").Rule('=');
  summary.Row("When Soar will learn rules", mode);
  summary.Row("Incorporate operator selection knowledge", YesNo(store.IsOn("chunk", "add-osk")));
  summary.Row("Interrupt after learning any rule", YesNo(store.IsOn("chunk", "interrupt")));
  summary.Row("Interrupt after learning from watched rule", YesNo(store.IsOn("chunk", "explain-interrupt")));
  summary.Row("Interrupt after learning failure", YesNo(store.IsOn("chunk", "warning-interrupt")));
  summary.Text("\n");
  summary.Row("Chunks learned", "0").Row("Justifications learned", "0").Row("Substates analyzed", "0");
  if (mode == "only") summary.Text("Only Learning In States\nNo current learning states.\n");
  summary.Rule('-');
  summary.Text(
      "\nTry 'chunk ?' to learn more about chunking's sub-commands and settings.\n"
      "For a detailed article about the chunk command, use 'help chunk'.\n");
  call.Out(summary.Take());
}

void Help(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  std::string text =
      "===================================================\n           Chunk Commands and Settings\n"
      "===================================================\n";
  text += fmt::format("{:<51}   {}\n", "chunk ? | help", "this overview");
  text += fmt::format("{:<51}   {}\n", "chunk stats", "what has been learned (not available in this build)");
  text += "------------------- Settings ----------------------\n";
  text += fmt::format("{:<{}}{}   {}\n", "always | never | only | except", 51 - store.Get("chunk", "mode").size(),
                      store.Get("chunk", "mode"), "when rules are learned");
  for (const SettingInfo& info : SettingStore::All()) {
    if (info.group != "chunk" || info.name == "mode") continue;
    const std::string value = store.Get("chunk", info.name);
    text += fmt::format("{:<{}}{}\n", info.name, 51 - value.size(), value);
  }
  text += "---------------------------------------------------\n\n";
  text += "To change a setting:                                  chunk <setting> [<value>]\n";
  call.Out(text);
}

constexpr std::string_view kModes[] = {"always", "never", "only", "except", "flagged", "unflagged"};

bool Chunk(CommandCall& call) {
  // Soar's chunk has no options and does not mind them.
  const auto plain = std::count_if(call.words.begin() + 1, call.words.end(),
                                   [](const Word& word) { return !word.text.starts_with('-'); });
  if (plain == 0) {
    Overview(call);
    return true;
  }
  const std::string& word = call.words[1].text;
  if (word == "?" || word == "help") {
    Help(call);
    return true;
  }
  std::string mode;
  for (const std::string_view name : kModes) {
    if (word == name) mode = name;
  }
  if (word == "on") mode = "only";
  if (word == "all") mode = "always";
  if (word == "off") mode = "never";
  if (!mode.empty() && call.words.size() == 2) {
    SetMode(call, mode);
    call.Out("Learns rules in states: " + (word == "all" || word == "off" ? word : mode) + "\n");
    return true;
  }
  if (word == "stats" || word == "singleton") {
    return call.Fail("'chunk " + word + "' needs learning, which is not available in this build.");
  }
  const bool done =
      NamedSetting(call, "chunk", "Invalid chunking command.  Use 'chunk ?' to see a list of valid settings.",
                   "Invalid argument for chunking command. Use 'chunk ?' to see a list of valid settings.");
  const std::string most = call.session.settings().Get("chunk", "max-dupes");
  call.agent().mutable_settings().max_duplicate_justifications =
      static_cast<std::uint32_t>(std::min(std::strtoull(most.c_str(), nullptr, 10), 0xFFFFFFFFull));
  return done;
}

constexpr OptionSpec kLearnTable[] = {
    {'e', "on", OptionArgument::kNone, "learn always"},
    {'e', "enable"},
    {'d', "off", OptionArgument::kNone, "never learn"},
    {'d', "disable"},
    {'E', "except", OptionArgument::kNone, "learn but in states that rules exclude"},
    {'o', "only", OptionArgument::kNone, "learn in states that rules name"},
    {'l', "list", OptionArgument::kNone, "show the settings"},
    {'a', "all-levels", OptionArgument::kNone, "learn in all states"},
    {'b', "bottom-up", OptionArgument::kNone, "learn in the lowest state only"},
    {'n', "enable-through-local-negations"},
    {'N', "disable-through-local-negations"},
    {'p', "enable-desirability-prefs"},
    {'P', "disable-desirability-prefs"},
};

constexpr SubcommandInfo kSubcommands[] = {
    {"always", "", "learn in all states"},
    {"never", "", "do not learn"},
    {"only", "", "learn in states that rules name"},
    {"except", "", "learn but in states that rules exclude"},
    {"stats", "", "what has been learned"},
    {"bottom-only", "[on | off]", "learn from the lowest state only"},
    {"naming-style", "[numbered | rule]", "how learned rules are named"},
    {"max-chunks", "[N]", "rules learned in one phase"},
    {"max-dupes", "[N]", "duplicates of one rule in one phase"},
    {"interrupt", "[on | off]", "stop after learning a rule"},
    {"explain-interrupt", "[on | off]", "stop after learning from a rule that explain records"},
    {"warning-interrupt", "[on | off]", "stop after a problem while learning"},
    {"singleton", "[TYPE ATTRIBUTE TYPE]", "elements that are taken to be unique"},
    {"automatically-create-singletons", "[on | off]", "take attributes with one value for unique"},
    {"add-ltm-links", "[on | off]", "rebuild links to semantic memory in results"},
    {"add-osk", "[on | off]", "include the knowledge that selected operators"},
    {"allow-local-negations", "[on | off]", "learn from what was absent in the substate"},
    {"allow-opaque", "[on | off]", "learn from long-term memory's recalls"},
};

}  // namespace

const std::span<const SubcommandInfo> kChunkSubcommands = kSubcommands;
const std::span<const OptionSpec> kLearnOptions = kLearnTable;

bool CommandChunk(CommandCall& call) {
  return Chunk(call);
}

bool CommandLearn(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kLearnTable, parsed)) return false;
  std::string equivalent = "chunk";
  const auto set = [&](const std::string& mode) {
    SetMode(call, mode);
    call.Out("learn is now " + mode + "\n");
    equivalent = "chunk " + mode;
  };
  bool listed = parsed.options.empty();
  for (const ParsedOption& option : parsed.options) {
    switch (option.letter) {
      case 'e':
        set("always");
        break;
      case 'd':
        set("never");
        break;
      case 'E':
        set("except");
        break;
      case 'o':
        set("only");
        break;
      case 'l':
        listed = true;
        break;
      case 'a':
        call.session.settings().Set("chunk", "bottom-only", "off");
        break;
      case 'b':
        call.session.settings().Set("chunk", "bottom-only", "on");
        break;
      case 'n':
        call.session.settings().Set("chunk", "allow-local-negations", "on");
        break;
      case 'N':
        call.session.settings().Set("chunk", "allow-local-negations", "off");
        break;
      default:
        break;
    }
  }
  if (listed) Overview(call);
  call.Out("Warning:  'learn' has been deprecated.  New corresponding command is: " + equivalent + "\n");
  return true;
}

bool CommandExplain(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  if (call.words.size() < 2) {
    Summary summary(55);
    summary.Rule('=').Text("                   Explainer Summary\n").Rule('=');
    summary.Row("Watch all chunk formations", YesNo(store.IsOn("explain", "all")));
    summary.Row("Explain justifications", YesNo(store.IsOn("explain", "justifications")));
    summary.Row("Number of specific rules watched", "0");
    summary.Text(
        "Rules watched:\nNo rule is currently being explained.\nNo chunks have been recorded.\n"
        "No justifications have been recorded.\n");
    summary.Rule('-');
    summary.Text(
        "\nUse 'explain chunk [ <chunk-name> | id ]' to explore the formation of that chunk.\n"
        "Use 'explain ?' to learn more about explain's sub-command and settings.\n");
    call.Out(summary.Take());
    return true;
  }
  const std::string& word = call.words[1].text;
  if (word == "all" && call.words.size() == 3) {
    const std::string& value = call.words[2].text;
    if (call.session.settings().Set("explain", "all", value) != SettingStore::SetResult::kOk) {
      return call.Fail("Invalid argument.  Use 'explain ?' to see a list of valid settings.");
    }
    call.Out(value == "on" ? "Will monitor all chunks created.\n"
                           : "Will only monitor specific chunks or time intervals.\n");
    return true;
  }
  for (const SubcommandInfo& subcommand : kExplainSubcommands) {
    if (subcommand.name == word && subcommand.usage != "[on | off]") {
      return call.Fail("'explain " + word + "' needs learning, which is not available in this build.");
    }
  }
  return NamedSetting(call, "explain",
                      "Invalid explain sub-command.  Use 'explain ?' to see a list of valid sub-commands and settings.",
                      "Invalid argument.  Use 'explain ?' to see a list of valid settings.");
}

namespace {
constexpr SubcommandInfo kExplainTable[] = {
    {"all", "[on | off]", "record how every rule is learned"},
    {"justifications", "[on | off]", "record justifications as well"},
    {"only-chunk-identities", "[on | off]", "show only what the learned rule contains"},
    {"record", "RULE", "record what is learned from a rule"},
    {"list-chunks", "", "rules that were learned"},
    {"list-justifications", "", "justifications that were made"},
    {"chunk", "[RULE | NUMBER]", "begin with a learned rule"},
    {"formation", "", "how it came about"},
    {"instantiation", "NUMBER", "one of the firings behind it"},
    {"explanation-trace", "", "show tests"},
    {"wm-trace", "", "show elements"},
    {"constraints", "", "tests that had to hold"},
    {"identity", "", "which variables are the same"},
    {"stats", "", "figures about it"},
};
}  // namespace

const std::span<const SubcommandInfo> kExplainSubcommands = kExplainTable;

bool CommandSvs(CommandCall& call) {
  if (call.words.size() < 2) {
    call.Out("Spatial Visual System is disabled.");
    return true;
  }
  const std::string& word = call.words[1].text;
  if (word == "--disable" || word == "--off" || word == "-d") {
    call.Out("Spatial Visual System disabled. ");
    return true;
  }
  if (word == "--enable" || word == "--on" || word == "-e") {
    return call.Fail("The Spatial Visual System is not available in this build.");
  }
  call.Out("Spatial Visual System is currently disabled.  Please enable to execute SVS commands.\n");
  return call.FailPrinted();
}

}  // namespace soarbox::cli
