// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/learning_text.h"
#include "cli/session.h"
#include "cli/setting_store.h"
#include "cli/settings_command.h"
#include "cli/summary.h"
#include "kernel/agent.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/learn/singletons.h"

namespace soarbox::cli {
namespace {

using kernel::LearnMode;
using kernel::LearnSettings;
using kernel::SingletonType;

/// Applies the stored settings to the kernel's learning.
void ApplyChunkSettings(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  const auto number = [&](std::string_view name) {
    return static_cast<std::uint32_t>(
        std::min(std::strtoull(store.Get("chunk", name).c_str(), nullptr, 10), 0xFFFFFFFFull));
  };
  const std::string mode = store.Get("chunk", "mode");
  call.agent().ChangeLearning([&](LearnSettings& settings) {
    settings.mode = mode == "always"                          ? LearnMode::kAlways
                    : mode == "only" || mode == "flagged"     ? LearnMode::kOnly
                    : mode == "except" || mode == "unflagged" ? LearnMode::kExcept
                                                              : LearnMode::kNever;
    settings.bottom_only = store.IsOn("chunk", "bottom-only");
    settings.numbered_names = store.Get("chunk", "naming-style") == "numbered";
    settings.max_chunks = number("max-chunks");
    settings.max_duplicates = number("max-dupes");
    settings.interrupt = store.IsOn("chunk", "interrupt");
    settings.explain_interrupt = store.IsOn("chunk", "explain-interrupt");
    settings.warning_interrupt = store.IsOn("chunk", "warning-interrupt");
    settings.automatic_singletons = store.IsOn("chunk", "automatically-create-singletons");
    settings.add_ltm_links = store.IsOn("chunk", "add-ltm-links");
    settings.add_selection_knowledge = store.IsOn("chunk", "add-osk");
    settings.allow_local_negations = store.IsOn("chunk", "allow-local-negations");
    settings.allow_opaque = store.IsOn("chunk", "allow-opaque");
  });
}

void SetChunkMode(CommandCall& call, const std::string& mode) {
  call.session.settings().Set("chunk", "mode", mode);
  ApplyChunkSettings(call);
}

std::string ChunkAnswer(bool yes) {
  return yes ? "Yes" : "No";
}

void ChunkOverview(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  const kernel::LearnStatistics& statistics = call.agent().learn_statistics();
  const std::string mode = store.Get("chunk", "mode");
  Summary summary(55);
  summary.Rule('=').Text("           Explanation-Based Chunking Summary\n").Rule('=');
  summary.Row("When Soar will learn rules", mode);
  summary.Row("Incorporate operator selection knowledge", ChunkAnswer(store.IsOn("chunk", "add-osk")));
  summary.Row("Interrupt after learning any rule", ChunkAnswer(store.IsOn("chunk", "interrupt")));
  summary.Row("Interrupt after learning from watched rule", ChunkAnswer(store.IsOn("chunk", "explain-interrupt")));
  summary.Row("Interrupt after learning failure", ChunkAnswer(store.IsOn("chunk", "warning-interrupt")));
  summary.Text("\n");
  summary.Row("Chunks learned", std::to_string(statistics.chunks));
  summary.Row("Justifications learned", std::to_string(statistics.justifications));
  summary.Row("Substates analyzed", std::to_string(statistics.analyzed));
  const LearnMode set = call.agent().learning().mode;
  if (set == LearnMode::kOnly || set == LearnMode::kExcept) {
    const bool only = set == LearnMode::kOnly;
    summary.Text(only ? "Only Learning In States\n" : "Learning in All States Except\n");
    const auto states = only ? call.agent().StatesForcedToLearn() : call.agent().StatesNotToLearn();
    if (states.empty()) summary.Text(only ? "No current learning states.\n" : "Currently learning in all states.\n");
    for (const kernel::Symbol state : states) {
      summary.Text("     " + kernel::ToString(call.agent().symbols(), state) + "\n");
    }
  }
  summary.Rule('-');
  summary.Text(
      "\nTry 'chunk ?' to learn more about chunking's sub-commands and settings.\n"
      "For a detailed article about the chunk command, use 'help chunk'.\n");
  call.Out(summary.Take());
}

void ChunkHelp(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  std::string text =
      "===================================================\n           Chunk Commands and Settings\n"
      "===================================================\n";
  const auto row = [&](std::string_view left, std::string_view what) { text += fmt::format("{:<54}{}\n", left, what); };
  const auto title = [&](std::string_view words) { text.append(words).append("\n"); };
  /// The active choice is printed in capitals.
  const auto choice = [&](std::string_view name, std::string_view one, std::string_view other, std::string_view end,
                          std::string_view what) {
    std::string words[] = {std::string(one), std::string(other)};
    for (std::string& word : words) {
      if (word == store.Get("chunk", name)) {
        std::ranges::transform(word, word.begin(),
                               [](char c) { return static_cast<char>(c - (c >= 'a' && c <= 'z' ? 32 : 0)); });
      }
    }
    const std::string right = "[ " + words[0] + " | " + words[1] + std::string(end);
    text += fmt::format("{:<{}}{}   {}\n", name, 51 - right.size(), right, what);
  };
  const auto on_off = [&](std::string_view name, std::string_view what) { choice(name, "on", "off", " ]", what); };
  const auto number = [&](std::string_view name, std::string_view what) {
    const std::string value = store.Get("chunk", name);
    text += fmt::format("{:<{}}{}         {}\n", name, 45 - value.size(), value, what);
  };
  row("chunk ? | help", "Print all EBC settings");
  row("chunk stats", "Print statistics on learning that has occurred");
  title("------------------- Settings ----------------------");
  std::string modes;
  for (const std::string_view mode : {"always", "never", "only", "except"}) {
    std::string word(mode);
    const std::string set = store.Get("chunk", "mode");
    if (set == mode || (set == "flagged" && mode == "only") || (set == "unflagged" && mode == "except")) {
      for (char& c : word) c = static_cast<char>(c - 32);
    }
    modes += (modes.empty() ? "" : " | ") + word;
  }
  row(modes, "When Soar will learn new rules");
  on_off("bottom-only", "Learn only from bottom sub-state");
  choice("naming-style", "numbered", "rule", "]", "Simple numeric chunk names or informational rule-based name");
  number("max-chunks", "Maximum chunks that can be learned (per phase)");
  number("max-dupes", "Maximum duplicate chunks (per rule, per phase)");
  title("------------------- Debugging ---------------------");
  on_off("interrupt", "Stop Soar after learning from any rule");
  on_off("explain-interrupt", "Stop Soar after learning rule watched by explainer");
  on_off("warning-interrupt", "Stop Soar after detecting learning issue");
  title("------------------- Fine Tune ---------------------");
  row("singleton", "Print all WME singletons");
  row("singleton                <type> <attribute> <type>", "Add a WME singleton pattern");
  row("singleton -r             <type> <attribute> <type>", "Remove a WME singleton pattern");
  on_off("automatically-create-singletons", "Attempt creating singletons for every string attribute");
  title("----------------- EBC Mechanisms ------------------");
  on_off("add-ltm-links", "Recreate LTM links in original results");
  on_off("add-osk", "Incorporate operator selection knowledge");
  title("---------- Correctness Guarantee Filters ----------   Allow rules to form that...");
  on_off("allow-local-negations", "...used local negative reasoning");
  on_off("allow-opaque", "...used knowledge from a LTM recall");
  title("---------------------------------------------------\n");
  row("To change a setting:", "chunk <setting> [<value>]");
  row("For a detailed explanation of these settings:", "help chunk");
  call.Out(text);
}

// Singletons ----------------------------------------------------------------------------------------------------------

constexpr std::string_view kTypes[] = {"any", "constant", "identifier", "operator", "state"};

std::optional<SingletonType> TypeOf(const std::string& word) {
  const auto found = std::ranges::find(kTypes, word);
  if (found == std::end(kTypes)) return std::nullopt;
  return static_cast<SingletonType>(found - kTypes);
}

std::string PatternText(SingletonType id, std::string_view attribute, SingletonType value) {
  return fmt::format("(<{}> ^{} <{}>)", kTypes[static_cast<std::size_t>(id)], attribute,
                     kTypes[static_cast<std::size_t>(value)]);
}

void ListSingletons(CommandCall& call) {
  if (call.agent().learning().automatic_singletons) call.agent().mutable_singletons().NoteAll();
  std::string text =
      "==== Singleton WME Unification Patterns ====\n"
      "----------------- Local --------------------\n"
      "   (<state> ^superstate <state>)\n\n"
      "-------------- Super-state -----------------\n"
      "   (<state> ^superstate <any>)\n"
      "   (<state> ^operator   <operator>)                   (unless condition only tests operator proposal)\n"
      "   (<state> ^type       <constant>)\n"
      "   (<state> ^impasse    <constant>)\n"
      "   (<state> ^smem       <identifier>)\n"
      "   (<state> ^epmem      <identifier>)\n"
      "   ---------- user-defined ----------\n";
  for (const kernel::Singletons::Pattern& pattern : call.agent().singletons().Patterns()) {
    text += "   " +
            PatternText(pattern.id, kernel::ToString(call.agent().symbols(), pattern.attribute), pattern.value) + "\n";
  }
  text +=
      "\n\nTo add a new pattern:    chunk singleton    <type> attribute <type>\n"
      "To remove a pattern:     chunk singleton -r <type> attribute <type>\n\n"
      "   Valid types:          [ any | constant | identifier | operator | state ]  \n";
  call.Out(text);
}

bool Singleton(CommandCall& call) {
  std::vector<std::string> words;
  bool remove = false, clear = false;
  for (std::size_t n = 2; n < call.words.size(); ++n) {
    const std::string& word = call.words[n].text;
    if (word == "-r" || word == "--remove") {
      remove = true;
    } else if (word == "-c" || word == "--clear") {
      clear = true;
    } else {
      words.push_back(word);
    }
  }
  if (clear && words.empty()) {
    call.agent().mutable_singletons().Clear();
    call.Out("User-defined singleton WME patterns cleared.\n");
    return true;
  }
  if (words.empty()) {
    ListSingletons(call);
    return true;
  }
  if (words.size() != 3) return call.Fail("Wrong number of arguments for the chunk command.");
  const auto id = TypeOf(words[0]), value = TypeOf(words[2]);
  constexpr std::string_view kMust = "Must be any, constant, identifier, operator, or state.";
  if (!id) {
    return call.Fail(fmt::format("Invalid pattern type for identifier element of singleton.  {}", kMust));
  }
  if (!value) return call.Fail(fmt::format("Invalid pattern type for value element of singleton.  {}", kMust));
  kernel::Singletons& singletons = call.agent().mutable_singletons();
  if (call.agent().learning().automatic_singletons) singletons.NoteAll();
  const kernel::Symbol attribute = call.agent().mutable_symbols().String(words[1]);
  const std::string pattern = PatternText(*id, words[1], *value);
  // While a file is read, changes of settings are not reported.
  const auto tell = [&](const std::string& text) {
    if (call.interpreter.source_run() == nullptr) call.Out(text);
  };
  if (kernel::Singletons::IsArchitecture(attribute) && (remove || *id == SingletonType::kState)) {
    tell(fmt::format("Soar cannot {} the architectural singleton for {}.  Ignoring.\n", remove ? "remove" : "override",
                     remove ? words[1] : pattern));
    return true;
  }
  if (remove) {
    if (singletons.Remove(attribute)) {
      tell(
          "Removed. Will no longer unify conditions in super-states that match a WME\n"
          "         that fits the pattern:  " +
          pattern + "\n");
    } else {
      tell("Could not find pattern " + pattern + ".  Did not remove.\n");
    }
    return true;
  }
  if (singletons.Set({attribute, *id, *value})) {
    tell(fmt::format("Clearing previous singleton for {}.\n", words[1]));
  }
  tell("Will unify conditions in super-states that match a WME that fits the pattern:  " + pattern + "\n");
  return true;
}

constexpr std::string_view kInvalidChunk = "Invalid chunking command.  Use 'chunk ?' to see a list of valid settings.";

constexpr std::string_view kModes[] = {"always", "never", "only", "except", "flagged", "unflagged"};

bool IsChunkMode(std::string_view word) {
  return std::ranges::find(kModes, word) != std::end(kModes) || word == "on" || word == "all" || word == "off";
}

/// Returns the sub-command that begins with a word, or the word itself if there is none. If there are several, `error`
/// lists them.
std::string FullChunkWord(const std::string& word, std::string& error) {
  if (IsChunkMode(word)) return word;
  std::vector<std::string_view> found;
  for (const SubcommandInfo& subcommand : kChunkSubcommands) {
    if (subcommand.name == word) return word;
    if (subcommand.name.starts_with(word)) found.push_back(subcommand.name);
  }
  if (std::string_view("learn").starts_with(word)) found.push_back("learn");
  if (found.size() > 1) error = DidYouMean(found);
  return found.empty() ? word : std::string(found.front());
}

/// `chunk learn [MODE]`: shows or sets the mode.
bool LearnSetting(CommandCall& call) {
  if (call.words.size() == 2) {
    call.Out("learn is " + call.session.settings().Get("chunk", "mode") + "\n");
    return true;
  }
  const std::string& value = call.words[2].text;
  if (call.words.size() > 3 || std::ranges::find(kModes, value) == std::end(kModes)) {
    return call.Fail("Invalid argument for chunking command. Use 'chunk ?' to see a list of valid settings.");
  }
  SetChunkMode(call, value);
  call.Out("learn is now " + value + "\n");
  return true;
}

bool Chunk(CommandCall& call) {
  if (call.words.size() > 1 && call.words[1].text.size() > 1 &&
      std::string_view("singleton").starts_with(call.words[1].text)) {
    return Singleton(call);
  }
  // Soar's chunk has no options: alone, they are ignored; together with other words, they are an error.
  const auto plain = std::count_if(call.words.begin() + 1, call.words.end(),
                                   [](const Word& word) { return !word.text.starts_with('-'); });
  if (plain == 0) {
    ChunkOverview(call);
    return true;
  }
  if (call.words[1].text == "?" || call.words[1].text == "help") {
    ChunkHelp(call);
    return true;
  }
  if (static_cast<std::size_t>(plain) + 1 < call.words.size()) return call.Fail(kInvalidChunk);
  std::string error;
  const std::string word = FullChunkWord(call.words[1].text, error);
  if (!error.empty()) return call.Fail(error + std::string(kInvalidChunk));
  if (word == "learn") return LearnSetting(call);
  std::string mode;
  for (const std::string_view name : kModes) {
    if (word == name) mode = name;
  }
  if (word == "on") mode = "only";
  if (word == "all") mode = "always";
  if (word == "off") mode = "never";
  if (!mode.empty() && call.words.size() == 2) {
    // "all" is a mode, but Soar also mentions the settings whose names begin with it.
    if (word == "all") call.Out("%?  Did you mean allow-local-negations, or allow-opaque?\n");
    SetChunkMode(call, mode);
    call.Out("Learns rules in states: " + (word == "all" || word == "off" ? word : mode) + "\n");
    return true;
  }
  if (word == "stats") {
    call.Out(LearningStatisticsText(call.agent()));
    return true;
  }
  const bool done =
      NamedSetting(call, "chunk", kInvalidChunk,
                   "Invalid argument for chunking command. Use 'chunk ?' to see a list of valid settings.");
  if (call.words.size() > 2) ApplyChunkSettings(call);
  return done;
}

constexpr OptionSpec kLearnTable[] = {
    {'e', "on", OptionArgument::kNone, "learn always"},
    {'e', "enable"},
    {'d', "off", OptionArgument::kNone, "never learn"},
    {'d', "disable"},
    {'E', "except", OptionArgument::kNone, "learn in all states except those that rules exclude"},
    {'o', "only", OptionArgument::kNone, "learn in states that rules name"},
    {'l', "list", OptionArgument::kNone, "show the settings"},
    {'a', "all-levels", OptionArgument::kNone, "learn in all states"},
    {'b', "bottom-up", OptionArgument::kNone, "learn in the lowest state only"},
    {'n', "enable-through-local-negations"},
    {'N', "disable-through-local-negations"},
    {'p', "enable-desirability-prefs"},
    {'P', "disable-desirability-prefs"},
};

constexpr SubcommandInfo kChunkSubcommandList[] = {
    {"always", "", "learn in all states"},
    {"never", "", "do not learn"},
    {"only", "", "learn in states that rules name"},
    {"except", "", "learn in all states except those that rules exclude"},
    {"stats", "", "what has been learned"},
    {"bottom-only", "[on | off]", "learn from the lowest state only"},
    {"naming-style", "[numbered | rule]", "how learned rules are named"},
    {"max-chunks", "[N]", "rules learned in one phase"},
    {"max-dupes", "[N]", "duplicates of one rule in one phase"},
    {"interrupt", "[on | off]", "stop after learning a rule"},
    {"explain-interrupt", "[on | off]", "stop after learning from a rule that explain records"},
    {"warning-interrupt", "[on | off]", "stop after a problem while learning"},
    {"singleton", "[TYPE ATTRIBUTE TYPE]", "elements that are treated as unique"},
    {"automatically-create-singletons", "[on | off]", "treat attributes with one value as unique"},
    {"add-ltm-links", "[on | off]", "rebuild links to semantic memory in results"},
    {"add-osk", "[on | off]", "include the reasons why operators were selected"},
    {"allow-local-negations", "[on | off]", "learn from what was absent in the substate"},
    {"allow-opaque", "[on | off]", "learn from long-term memory's recalls"},
};

}  // namespace

const std::span<const SubcommandInfo> kChunkSubcommands = kChunkSubcommandList;
const std::span<const OptionSpec> kLearnOptions = kLearnTable;

bool CommandChunk(CommandCall& call) {
  return Chunk(call);
}

bool CommandLearn(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kLearnTable, parsed)) return false;
  std::string equivalent = "chunk";
  const auto set = [&](const std::string& mode) {
    SetChunkMode(call, mode);
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
  ApplyChunkSettings(call);
  if (listed) ChunkOverview(call);
  call.Out("Warning:  'learn' has been deprecated.  New corresponding command is: " + equivalent + "\n");
  return true;
}

}  // namespace soarbox::cli
