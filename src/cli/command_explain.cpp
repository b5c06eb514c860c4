// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "cli/command.h"
#include "cli/explain_text.h"
#include "cli/session.h"
#include "cli/setting_store.h"
#include "cli/summary.h"
#include "kernel/agent.h"
#include "kernel/learn/explanation_log.h"

namespace soarbox::cli {
namespace {

using kernel::ExplainedRule;

std::string ExplainAnswer(bool yes) {
  return yes ? "Yes" : "No";
}

/// The rule chosen with `explain chunk`, or null.
const ExplainedRule* ChosenRule(CommandCall& call) {
  for (const ExplainedRule& rule : call.agent().explanations().rules()) {
    if (rule.number == call.session.explain().rule) return &rule;
  }
  return nullptr;
}

bool AnyExplained(CommandCall& call, bool justifications) {
  return std::ranges::any_of(call.agent().explanations().rules(),
                             [&](const ExplainedRule& rule) { return rule.justification == justifications; });
}

/// Lists at most `most` recorded rules of one kind, one per line. The first line begins with `first`, the others with
/// `margin` blanks. `listed` receives the number of rules in the list.
std::string ListedRules(CommandCall& call, bool justifications, std::string_view first, std::size_t margin,
                        std::size_t most, std::size_t& listed) {
  std::string text(first);
  listed = 0;
  for (const ExplainedRule& rule : call.agent().explanations().rules()) {
    if (rule.justification != justifications || listed == most) continue;
    if (listed > 0 || first.empty()) text += std::string(margin, ' ');
    ++listed;
    text += fmt::format("{} (c {})\n", rule.name, rule.number);
  }
  return text;
}

constexpr std::size_t kMostInOverview = 10;

void ExplainOverview(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  const std::vector<std::string>& watched = call.agent().explanations().watched;
  Summary summary(55);
  if (call.session.stream().column() != 0) summary.Text("\n");
  summary.Rule('=').Text("                   Explainer Summary\n").Rule('=');
  summary.Text(fmt::format("{:<54}{}\n", "Watch all chunk formations", ExplainAnswer(store.IsOn("explain", "all"))));
  summary.Text(
      fmt::format("{:<54}{}\n", "Explain justifications", ExplainAnswer(store.IsOn("explain", "justifications"))));
  summary.Row("Number of specific rules watched", std::to_string(watched.size()));
  if (!watched.empty()) {
    std::string text = fmt::format("{:<54}", "Rules watched:");
    for (std::size_t n = 0; n < watched.size(); ++n) text += (n == 0 ? "" : std::string(54, ' ')) + watched[n] + "\n";
    for (const std::string& learned : call.agent().explanations().watched_learned)
      text += std::string(54, ' ') + learned + "\n";
    summary.Text(text + "\n");
  } else {
    summary.Text(store.IsOn("explain", "all") ? "\n" : "Rules watched:\n");
  }
  if (const ExplainedRule* const current = ChosenRule(call); current != nullptr) {
    summary.Text(fmt::format("{:<54}{} (c {})\n\n", "Current rule being explained:", current->name, current->number));
  } else {
    summary.Text("No rule is currently being explained.\n");
  }
  for (const bool justifications : {false, true}) {
    const std::string kind = justifications ? "Justifications" : "Chunks";
    if (AnyExplained(call, justifications)) {
      std::size_t listed = 0;
      summary.Text(ListedRules(call, justifications, fmt::format("{:<54}", kind + " available for explanation:"), 54,
                               kMostInOverview, listed) +
                   "\n");
      // As in Soar 9.6.3, the number of rules that are not listed includes those of the other kind.
      const std::string plural = justifications ? "justifications" : "chunks";
      if (const std::size_t all = call.agent().explanations().rules().size(); all > listed) {
        summary.Text(fmt::format(
            "* Note:  Only listed the first {} {} recorded.  Type 'explain list-{}' to see the other {} {}.\n\n",
            kMostInOverview, plural, plural, all - listed, plural));
      }
    } else {
      summary.Text(justifications ? "No justifications have been recorded.\n" : "No chunks have been recorded.\n");
    }
  }
  summary.Rule('-');
  summary.Text(
      "\nUse 'explain chunk [ <chunk-name> | id ]' to explore the formation of that chunk.\n"
      "Use 'explain ?' to learn more about explain's sub-command and settings.\n");
  call.Out(summary.Take());
}

void ExplainHelp(CommandCall& call) {
  const SettingStore& store = call.session.settings();
  std::string text = "========= Explainer Commands and Settings =========\n";
  const auto row = [&](std::string_view left, std::string_view what) { text += fmt::format("{:<54}{}\n", left, what); };
  const auto setting = [&](std::string_view name, std::string_view what) {
    row(fmt::format("{:<39}{}", name, store.IsOn("explain", name) ? "[ ON | off ]" : "[ on | OFF ]"), what);
  };
  row("explain ?", "Print this help listing");
  text += "------------------ What to Record -----------------\n";
  setting("all", "Whether to record all rules that are learned");
  setting("justifications", "Whether to record justifications");
  row("record <chunk-name>", "Record any chunks formed from a specific rule");
  row("list-chunks", "List all rules learned");
  row("list-justifications", "List all justifications learned");
  text += "------------- Starting an Explanation -------------\n";
  row("chunk [<chunk name> | <chunk id> ]", "Start discussing chunk");
  row("formation", "Describe initial formation of chunk");
  text += "------------- Browsing an Explanation -------------\n";
  row("instantiation <inst id>", "Explain instantiation");
  row("explanation-trace", "Switch to explanation trace inspection");
  row("wm-trace", "Switch to working memory trace inspection");
  text += "-------------- Supporting Analysis ----------------\n";
  row("constraints", "Display extra transitive constraints required by problem-solving");
  row("identity", "Display identity to identity set mappings");
  row("stats", "Display statistics about currently discussed chunk");
  setting("only-chunk-identities", "Identity analysis only prints identities sets found in chunk");
  text += "---------------------------------------------------\n\n";
  row("To change a setting:", "explain <setting> [<value>]");
  row("For a detailed explanation of these settings:", "help explain");
  call.Out(text);
}

bool SetExplainSwitch(CommandCall& call, const std::string& name) {
  SettingStore& store = call.session.settings();
  if (call.words.size() == 2) {
    const std::string_view negation = store.IsOn("explain", name) ? " " : " not ";
    if (name == "all") {
      call.Out(fmt::format("The explainer is{}currently recording all rules formed.\n", negation));
    } else if (name == "justifications") {
      call.Out(fmt::format("The explainer is{}currently recording justifications created.\n", negation));
    } else {
      call.Out(fmt::format("The explainer is currently showing identity analysis {}.\n",
                           store.IsOn("explain", name) ? "only for identities that appear in the chunk"
                                                       : "for all identities involved in problem-solving"));
    }
    return true;
  }
  if (call.words.size() > 3 || store.Set("explain", name, call.words[2].text) != SettingStore::SetResult::kOk) {
    return call.Fail(
        "Invalid argument for explain command. Use 'explain ?' to see a list of valid sub-commands and settings.");
  }
  const bool on = store.IsOn("explain", name);
  call.agent().mutable_explanations().all = store.IsOn("explain", "all");
  call.agent().mutable_explanations().justifications = store.IsOn("explain", "justifications");
  if (name == "all") {
    call.Out(on ? "Will monitor all chunks created.\n" : "Will only monitor specific chunks.\n");
  } else if (name == "justifications") {
    call.Out(on ? "Will record justifications created.\n" : "Will not record justifications created.\n");
  } else {
    call.Out(on ? "Will only print identities that appear in the chunk.\n"
                : "Will print all identities involved in problem-solving.\n");
  }
  return true;
}

bool WatchRule(CommandCall& call) {
  if (call.words.size() == 2) {
    std::string text = "Rules watched:\n";
    for (const std::string& watched : call.agent().explanations().watched) text += "   " + watched + "\n";
    call.Out(text);
    return true;
  }
  if (call.words.size() != 3) return call.Fail("Please name the rule whose chunks are to be recorded.");
  const std::string& name = call.words[2].text;
  if (call.agent().FindProduction(name) == kernel::ProductionId::kNone) {
    call.Out(fmt::format("Could not find a rule named {} to watch.\nType 'print' to see a list of all rules.\n", name));
    return call.FailPrinted();
  }
  std::vector<std::string>& watched = call.agent().mutable_explanations().watched;
  const bool on = std::erase(watched, name) == 0;
  if (on) watched.push_back(name);
  call.Out(fmt::format("{} watching any chunks formed by rule '{}'\n", on ? "Now" : "No longer", name));
  return true;
}

constexpr std::string_view kSeeLists =
    "Type 'explain list-chunks' or 'explain list-justifications' to see a list of rule formations Soar has recorded.\n";

constexpr std::string_view kInvalidExplain =
    "Invalid explain sub-command.  Use 'explain ?' to see a list of valid sub-commands and settings.";

bool IsLoadedRule(CommandCall& call, const std::string& name) {
  return call.agent().FindProduction(name) != kernel::ProductionId::kNone ||
         std::ranges::any_of(call.agent().Justifications(),
                             [&](const kernel::ProductionPtr& justification) { return justification->name == name; });
}

LoadedRules LoadedIn(CommandCall& call) {
  return [&call](const std::string& name) { return IsLoadedRule(call, name); };
}

/// A copy of the rule in which a tested element has a creator only if a recorded explanation contains that firing.
ExplainedRule WithKnownCreators(CommandCall& call, ExplainedRule rule) {
  const std::vector<ExplainedRule>& explained = call.agent().explanations().rules();
  for (ExplainedRule::Condition& condition : rule.conditions) {
    const auto has_it = [&](const ExplainedRule& other) { return other.FindFiring(condition.creator) != nullptr; };
    if (condition.creator != 0 && std::ranges::none_of(explained, has_it)) condition.creator = 0;
  }
  return rule;
}

bool ExplainChunk(CommandCall& call) {
  if (call.words.size() != 3) return call.Fail("Please specify the chunk using either the chunk's name or its ID.");
  const std::string& word = call.words[2].text;
  const std::vector<ExplainedRule>& rules = call.agent().explanations().rules();
  const bool is_number = std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
  const ExplainedRule* found = nullptr;
  for (const ExplainedRule& rule : rules) {
    if (is_number ? std::to_string(rule.number) == word : rule.name == word) found = &rule;
  }
  if (found == nullptr) {
    if (is_number) {
      call.Out(fmt::format("Could not find a rule name or id {}.\n{}", word, kSeeLists));
    } else {
      if (IsLoadedRule(call, word))
        call.Out(fmt::format("Soar has not recorded an explanation for {}.\n{}", word, kSeeLists));
    }
    return call.FailPrinted();
  }
  call.session.explain().rule = found->number;
  call.session.explain().firing = 0;
  call.Out(fmt::format("Now explaining {}.\n{}", found->name, is_number ? "" : "\n") +
           ExplainedRuleText(WithKnownCreators(call, *found), call.session.explain().elements, LoadedIn(call)));
  return true;
}

/// Finds a firing by its number: the instance of this rule, a firing that it recorded, or one of another recorded rule.
/// The latter made no result of this rule.
std::optional<ExplainedRule::Firing> FindFiring(CommandCall& call, const ExplainedRule& rule, std::uint32_t serial) {
  if (serial == rule.instance) return LearnedInstance(WithKnownCreators(call, rule));
  if (const ExplainedRule::Firing* const firing = rule.FindFiring(serial); firing != nullptr) return *firing;
  for (const ExplainedRule& other : call.agent().explanations().rules()) {
    const ExplainedRule::Firing* const known = other.FindFiring(serial);
    if (known == nullptr && serial != other.instance) continue;
    ExplainedRule::Firing firing = known != nullptr ? *known : LearnedInstance(WithKnownCreators(call, other));
    // As in Soar 9.6.3, there is an exception: the instance of a rule that was learned earlier.
    firing.made_result = known == nullptr && other.number < rule.number;
    firing.path.clear();
    return firing;
  }
  return std::nullopt;
}

void ShowFiring(CommandCall& call, const ExplainedRule& rule) {
  const ExplainState& state = call.session.explain();
  if (state.firing == 0) {
    call.Out(ExplainedRuleText(WithKnownCreators(call, rule), state.elements, LoadedIn(call)));
    return;
  }
  const LoadedRules loaded = LoadedIn(call);
  const std::optional<ExplainedRule::Firing> firing = FindFiring(call, rule, state.firing);
  if (!firing) return;
  const bool menu = state.elements || !loaded(firing->rule);
  call.Out(ExplainedFiringText(rule, *firing, state.elements, loaded) + (menu ? ExplainMenu(true) : ""));
}

bool ExplainFiring(CommandCall& call, const ExplainedRule& rule) {
  if (call.words.size() != 3) return call.Fail("Please specify the instantiation by its number.");
  const std::string& word = call.words[2].text;
  const bool is_number = std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
  if (!is_number) call.Out("The instantiation ID must be a number.\n");
  const std::uint64_t number = is_number ? std::strtoull(word.c_str(), nullptr, 10) : 0;
  if (!FindFiring(call, rule, static_cast<std::uint32_t>(number))) {
    call.Out(fmt::format("Could not find an instantiation with ID {}.\n", number));
    return call.FailPrinted();
  }
  call.session.explain().firing = static_cast<std::uint32_t>(number);
  ShowFiring(call, rule);
  return true;
}

/// Completes the one-letter abbreviations of the menu, and unique prefixes. If several words are possible, `error`
/// lists them.
std::string FullExplainWord(const std::string& word, std::string& error) {
  if (word == "f") return "formation";
  if (word == "c") return "constraints";
  if (word == "i") return "identity";
  if (word == "s") return "stats";
  if (word == "w") return "wm-trace";
  if (word == "e") return "explanation-trace";
  std::vector<std::string_view> found;
  for (const SubcommandInfo& subcommand : kExplainSubcommands) {
    if (subcommand.name == word) return word;
    if (subcommand.name.starts_with(word)) found.push_back(subcommand.name);
  }
  if (found.size() > 1) error = DidYouMean(found);
  return found.empty() ? word : std::string(found.front());
}

}  // namespace

bool CommandExplain(CommandCall& call) {
  if (call.words.size() < 2) {
    ExplainOverview(call);
    return true;
  }
  std::string error;
  const std::string word = FullExplainWord(call.words[1].text, error);
  if (!error.empty()) return call.Fail(error + std::string(kInvalidExplain));
  if (word == "?" || word == "help") {
    ExplainHelp(call);
    return true;
  }
  if (word == "all" || word == "justifications" || word == "only-chunk-identities") return SetExplainSwitch(call, word);
  if (word == "record") return WatchRule(call);
  if (word == "chunk") return ExplainChunk(call);
  if (word == "list-chunks" || word == "list-justifications") {
    const bool justifications = word == "list-justifications";
    std::size_t listed = 0;
    if (AnyExplained(call, justifications)) {
      call.Out(fmt::format("{} available for explanation:\n", justifications ? "Justifications" : "Chunks") +
               ListedRules(call, justifications, "", 3, std::string::npos, listed));
    } else {
      call.Out(justifications ? "No justifications have been recorded.\n" : "No chunks have been recorded.\n");
    }
    return true;
  }
  const bool known = std::ranges::any_of(kExplainSubcommands,
                                         [&](const SubcommandInfo& subcommand) { return subcommand.name == word; });
  if (!known) {
    return call.Fail(kInvalidExplain);
  }
  ExplainState& state = call.session.explain();
  const ExplainedRule* const chosen = ChosenRule(call);
  if (chosen == nullptr) {
    return call.Fail(
        "Please first specify the chunk you want to discuss with the command 'explain chunk [chunk-name | chunk ID]'.");
  }
  const ExplainedRule& rule = *chosen;
  if (word == "instantiation") return ExplainFiring(call, rule);
  if (word == "formation") {
    call.Out(FormationText(rule, state.elements, LoadedIn(call)));
  } else if (word == "identity") {
    call.Out(IdentityText(rule));
  } else if (word == "constraints") {
    call.Out(ConstraintsText(rule));
  } else if (word == "stats") {
    call.Out(ExplainedStatisticsText(rule));
  } else {
    state.elements = word == "wm-trace";
    ShowFiring(call, rule);
  }
  return true;
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
    {"instantiation", "NUMBER", "one of the firings that led to it"},
    {"explanation-trace", "", "show tests"},
    {"wm-trace", "", "show elements"},
    {"constraints", "", "tests that had to be true"},
    {"identity", "", "which variables are the same"},
    {"stats", "", "figures about it"},
};
}  // namespace

const std::span<const SubcommandInfo> kExplainSubcommands = kExplainTable;

}  // namespace soarbox::cli
