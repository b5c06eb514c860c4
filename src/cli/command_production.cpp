// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/find_rules.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/matches_printer.h"
#include "cli/printed_rule.h"
#include "cli/rule_crowds.h"
#include "cli/soar_sort.h"
#include "cli/source_run.h"
#include "cli/summary.h"

namespace soarbox::cli {
namespace {

using kernel::Production;
using kernel::ProductionId;
using kernel::ProductionType;

constexpr auto kNone = OptionArgument::kNone;

bool ProductionOverview(CommandCall& call) {
  const kernel::Agent& agent = call.agent();
  std::uint32_t total = 0;
  Summary summary(55);
  summary.Rule('=').Title("Productions", '-').Rule('=');
  const auto row = [&](std::string_view name, ProductionType type) {
    const std::uint32_t count = agent.CountProductions(type);
    total += count;
    const std::string number = std::to_string(count);
    summary.Text(fmt::format("{:<{}}{}   \n", name, 55 - number.size(), number));
  };
  row("User rules", ProductionType::kUser);
  row("Default rules", ProductionType::kDefault);
  row("Chunks", ProductionType::kChunk);
  row("Justifications", ProductionType::kJustification);
  summary.Rule('-');
  const std::string number = std::to_string(total);
  summary.Text(fmt::format("{:<{}}{}   \n", "Total", 55 - number.size(), number));
  summary.Rule('-');
  summary.Text("\nUse 'production ?' for a command overview or 'help production' for the manual page.");
  call.Out(summary.Take());
  return true;
}

/// The rules of the types in the options, oldest first; all rules without such options.
std::vector<ProductionId> Selected(CommandCall& call, const ParsedWords& parsed) {
  struct Letter {
    char letter;
    ProductionType type;
  };
  constexpr Letter kLetters[] = {{'u', ProductionType::kUser},
                                 {'c', ProductionType::kChunk},
                                 {'d', ProductionType::kDefault},
                                 {'j', ProductionType::kJustification},
                                 {'T', ProductionType::kTemplate}};
  bool any = parsed.Has('r');
  for (const Letter& letter : kLetters) any = any || parsed.Has(letter.letter);
  std::vector<ProductionId> rules;
  for (const ProductionId id : call.agent().Productions()) {
    const Production& rule = call.agent().production(id);
    bool wanted = !any || parsed.Has('a') || (parsed.Has('r') && rule.is_rl);
    for (const Letter& letter : kLetters) wanted = wanted || (parsed.Has(letter.letter) && rule.type == letter.type);
    if (wanted) rules.push_back(id);
  }
  return rules;
}

constexpr OptionSpec kExciseOptions[] = {
    {'a', "all", kNone, "all rules"},
    {'c', "chunks", kNone, "learned rules"},
    {'d', "default", kNone, "default rules"},
    {'n', "never-fired", kNone, "rules that never fired"},
    {'r', "rl", kNone, "reinforcement learning's"},
    {'t', "task", kNone, "user and default rules"},
    {'T', "templates", kNone, "templates"},
    {'u', "user", kNone, "ordinary rules"},
};

bool Excise(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kExciseOptions, parsed)) return false;
  kernel::Agent& agent = call.agent();
  std::vector<ProductionId> rules;
  if (parsed.options.empty()) {
    if (parsed.arguments.empty()) return call.Fail("Production name is required.");
    if (parsed.arguments.size() > 1) {
      return call.Fail(
          "Only one production name allowed, call excise multiple times to excise more than one specific "
          "production.");
    }
    const ProductionId id = FindRule(agent, parsed.arguments.front().text);
    if (id == ProductionId::kNone) {
      if (!agent.ExciseJustification(parsed.arguments.front().text)) return call.Fail("Production not found.");
      call.Out("1 production excised.\n");
      return true;
    }
    rules.push_back(id);
  } else {
    if (!parsed.arguments.empty()) return call.Fail("Invalid additional arguments.");
    for (const ProductionId id : agent.Productions()) {
      const Production& rule = agent.production(id);
      const bool wanted =
          parsed.Has('a') || (parsed.Has('c') && rule.type == ProductionType::kChunk) ||
          (parsed.Has('d') && rule.type == ProductionType::kDefault) ||
          (parsed.Has('u') && rule.type == ProductionType::kUser) ||
          (parsed.Has('T') && rule.type == ProductionType::kTemplate) ||
          (parsed.Has('t') && (rule.type == ProductionType::kUser || rule.type == ProductionType::kDefault)) ||
          (parsed.Has('r') && rule.is_rl) || (parsed.Has('n') && agent.FiringCount(id) == 0);
      if (wanted) rules.push_back(id);
    }
  }
  std::size_t count = rules.size();
  if (parsed.Has('a')) {
    // Templates are excised too, but not counted.
    count -= static_cast<std::size_t>(std::count_if(rules.begin(), rules.end(), [&](ProductionId id) {
      return agent.production(id).type == ProductionType::kTemplate;
    }));
  }
  if (parsed.Has('a') || parsed.Has('c')) {
    for (const kernel::ProductionPtr& rule : agent.Justifications()) {
      count += agent.ExciseJustification(rule->name) ? 1 : 0;
    }
  }
  std::vector<std::string>& watched = call.session.watched_rules();
  for (const ProductionId id : rules) {
    const std::string name(agent.production(id).name);
    std::erase(watched, name);
    call.AddArgument("name", "string", name);
    if (parsed.Has('n') || parsed.Has('r')) call.Out("#");
    if (SourceRun* source = call.interpreter.source_run()) source->counts.excised.push_back(name);
    agent.Excise(id);
  }
  call.session.UpdateTrace();
  call.AddArgument("count", "int", std::to_string(count));
  call.Out(fmt::format("{} production{} excised.\n", count, count == 1 ? "" : "s"));
  return true;
}

constexpr OptionSpec kWatchOptions[] = {
    {'e', "on", kNone, "show firings of the rule"},
    {'d', "off", kNone, "no longer show them"},
};

bool Watch(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kWatchOptions, parsed)) return false;
  if (parsed.arguments.size() > 1) return call.Fail("Too many parameters");
  std::vector<std::string>& watched = call.session.watched_rules();
  if (parsed.arguments.empty()) {
    if (parsed.Has('d')) {
      watched.clear();
      call.session.UpdateTrace();
      return true;
    }
    if (watched.empty()) {
      call.Out("No watched productions found.");
      return true;
    }
    for (const ProductionType type : {ProductionType::kUser, ProductionType::kDefault, ProductionType::kChunk,
                                      ProductionType::kJustification, ProductionType::kTemplate}) {
      for (const ProductionId id : RulesOfType(call.agent(), type)) {
        const std::string name(call.agent().production(id).name);
        if (std::find(watched.begin(), watched.end(), name) == watched.end()) continue;
        call.Out("\n" + name);
        call.AddArgument("name", "string", name);
      }
    }
    return true;
  }
  const ProductionId id = FindRule(call.agent(), parsed.arguments.front().text);
  if (id == ProductionId::kNone) return call.Fail("Production not found.");
  const std::string name(call.agent().production(id).name);
  std::erase(watched, name);
  if (!parsed.Has('d')) watched.push_back(name);
  call.session.UpdateTrace();
  return true;
}

constexpr OptionSpec kBreakOptions[] = {
    {'s', "set", kNone, "stop when this rule matches"},
    {'c', "clear", kNone, "no longer stop at this rule"},
    {'p', "print", kNone, "list the rules at which runs stop"},
};

bool Break(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kBreakOptions, parsed)) return false;
  kernel::Agent& agent = call.agent();
  if ((parsed.Has('s') || parsed.Has('c')) && parsed.arguments.size() != 1) {
    return call.Fail("pbreak --set/--clear takes exactly one argument.");
  }
  if (parsed.Has('p') && !parsed.arguments.empty()) return call.Fail("pbreak --print takes no arguments.");
  if (parsed.arguments.size() > 1) return call.Fail("pbreak used incorrectly.");
  if (parsed.arguments.empty()) {
    call.result.structured.Add("break");
    std::vector<ProductionId> rules = agent.Productions();
    std::reverse(rules.begin(), rules.end());
    for (const ProductionId id : rules) {
      if (!agent.HasBreak(id) && !agent.production(id).interrupt) continue;
      if (agent.HasBreak(id)) call.Out(RuleName(agent, agent.production(id)) + "\n");
    }
    return true;
  }
  const std::string& name = parsed.arguments.front().text;
  const ProductionId id = FindRule(agent, name);
  if (id == ProductionId::kNone) return call.Fail("Production not found: " + name);
  agent.SetBreak(id, !parsed.Has('c'));
  return true;
}

constexpr OptionSpec kFindOptions[] = {
    {'l', "lhs", kNone, "search conditions"},
    {'r', "rhs", kNone, "search actions"},
    {'s', "show-bindings", kNone, "show the values of the pattern's variables"},
    {'c', "chunks", kNone, "learned rules only"},
    {'n', "nochunks", kNone, "no learned rules"},
};

bool Find(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kFindOptions, parsed)) return false;
  if (parsed.arguments.empty()) return call.Fail("No pattern specified.");
  std::string pattern;
  for (const Word& word : parsed.arguments) pattern += (pattern.empty() ? "" : " ") + word.text;
  PrintStream::Capture capture(call.stream(), &call.result.text);
  // With options, but without --lhs and --rhs, Soar finds nothing. We do the same, and add a hint.
  const bool searches = parsed.options.empty() || parsed.Has('l') || parsed.Has('r');
  if (!searches) call.Hint("nothing is searched", "give --lhs as well");
  FindRules(call.stream(), call.agent(), pattern, searches, parsed.Has('s'), [&](const Production& rule) {
    const bool learned = rule.type == ProductionType::kChunk || rule.type == ProductionType::kJustification;
    return searches && !(parsed.Has('c') && !learned) && !(parsed.Has('n') && learned);
  });
  return true;
}

/// A line "COUNT:  NAME".
struct Counted {
  std::uint64_t number = 0;
  std::string name;
};

void PrintCounts(CommandCall& call, const std::vector<Counted>& lines) {
  for (const Counted& line : lines) {
    call.Out(fmt::format("{:6}:  {}\n", line.number, line.name));
    call.AddArgument("name", "string", line.name);
    call.AddArgument("count", "int", std::to_string(line.number));
  }
}

/// The wanted rules with their counts, in the order of `types`, and newest first within a type. `in_bars`: puts names
/// in bars if necessary.
template <typename Wanted, typename Count>
std::vector<Counted> CountRules(CommandCall& call, std::initializer_list<ProductionType> types, bool in_bars,
                                Wanted&& wanted, Count&& count) {
  const kernel::Agent& agent = call.agent();
  std::vector<Counted> lines;
  const auto name_of = [&](const Production& rule) { return in_bars ? RuleName(agent, rule) : std::string(rule.name); };
  for (const ProductionType type : types) {
    if (type == ProductionType::kJustification) {
      const std::vector<kernel::ProductionPtr> rules = agent.Justifications();
      for (auto rule = rules.rbegin(); rule != rules.rend(); ++rule) {
        if (wanted(**rule)) lines.push_back({count(ProductionId::kNone), name_of(**rule)});
      }
      continue;
    }
    for (const ProductionId id : RulesOfType(agent, type)) {
      const Production& rule = agent.production(id);
      if (wanted(rule)) lines.push_back({count(id), name_of(rule)});
    }
  }
  return lines;
}

/// Sorts by count, largest first, and cuts the list to `limit` lines (0: all). Equal counts are in the same order as in
/// Soar: it sorts in ascending order, with a sort that is stable only for short lists, and reverses the list.
void SortCounts(std::vector<Counted>& lines, std::size_t limit) {
  SortLikeSoar(lines, [](const Counted& a, const Counted& b) { return a.number < b.number; });
  std::reverse(lines.begin(), lines.end());
  if (limit > 0 && lines.size() > limit) lines.resize(limit);
}

constexpr OptionSpec kCountOptions[] = {
    {'a', "all", kNone, "all rules"},
    {'c', "chunks", kNone, "learned rules"},
    {'d', "default", kNone, "default rules"},
    {'j', "justifications", kNone, "justifications"},
    {'r', "rl", kNone, "reinforcement learning's"},
    {'T', "templates", kNone, "templates"},
    {'u', "user", kNone, "ordinary rules"},
    {'f', "fired", kNone, "only rules that fired"},
};

bool FiringCounts(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kCountOptions, parsed)) return false;
  if (parsed.arguments.size() > 1) return call.Fail("Too many parameters.");
  const auto count = [&](ProductionId id) { return call.agent().FiringCount(id); };
  std::size_t limit = 0;
  bool number_given = false;
  if (!parsed.arguments.empty()) {
    const std::string& word = parsed.arguments.front().text;
    const auto number = ParseLeadingInteger(word);
    if (!number) {
      const ProductionId id = FindRule(call.agent(), word);
      const bool has_options = !parsed.options.empty();
      if (has_options) {
        call.Out("Ignoring unexpected options when printing firing count for a single production.\n");
      }
      if (id == ProductionId::kNone) return call.Fail("Production not found.");
      PrintCounts(call, {{count(id), std::string(call.agent().production(id).name)}});
      if (has_options) call.failure = CommandCall::Failure::kReported;
      return !has_options;
    }
    if (*number < 0) return call.Fail("Expected non-negative integer.");
    number_given = true;
    limit = static_cast<std::size_t>(*number);
  }
  // Like in Soar, the option for templates shows all rules.
  const auto asks_for = [&](char letter) { return parsed.Has(letter); };
  const bool all = parsed.Has('a') || parsed.Has('T') || std::ranges::none_of(std::string_view("cdjru"), asks_for);
  const auto wanted = [&](const Production& rule) {
    if (all) return true;
    // Rules of reinforcement learning are a separate type.
    if (rule.is_rl) return parsed.Has('r');
    switch (rule.type) {
      case ProductionType::kUser:
        return parsed.Has('u');
      case ProductionType::kChunk:
        return parsed.Has('c');
      case ProductionType::kDefault:
        return parsed.Has('d');
      case ProductionType::kJustification:
        return parsed.Has('j');
      case ProductionType::kTemplate:
        break;
    }
    return false;
  };
  std::vector<Counted> lines =
      CountRules(call,
                 {ProductionType::kChunk, ProductionType::kDefault, ProductionType::kJustification,
                  ProductionType::kUser, ProductionType::kTemplate},
                 false, wanted, [&](ProductionId id) { return id == ProductionId::kNone ? 0 : count(id); });
  if (lines.empty()) return call.Fail("No productions in memory of those type(s).");
  if (parsed.Has('f')) std::erase_if(lines, [&](const Counted& line) { return line.number == 0; });
  // Zero means the rules that have never fired.
  if (number_given && limit == 0) std::erase_if(lines, [&](const Counted& line) { return line.number > 0; });
  SortCounts(lines, limit);
  PrintCounts(call, lines);
  return true;
}

/// A hint for a rule with very many partial matches per firing; else empty.
std::string CrowdText(const kernel::Agent& agent, ProductionId id) {
  constexpr std::size_t kMany = 10'000;
  constexpr std::size_t kManyForEach = 1'000;
  const std::size_t held = agent.rete().CountTokens(id, false);
  const std::uint64_t fired = agent.FiringCount(id);
  if (held < kMany || held / kManyForEach <= fired) return {};
  const kernel::Production& rule = agent.production(id);
  const std::optional<RuleCrowd> crowd = FindCrowd(rule);
  return fmt::format("{} has held {} partial matches for {} {}: {}.\n", RuleName(agent, rule), held, fired,
                     fired == 1 ? "match" : "matches",
                     crowd ? AdviceFor(rule, *crowd, agent.symbols())
                           : "test earlier what few elements have, or declare `multi-attributes` for the attributes "
                             "that have many values");
}

constexpr OptionSpec kMemoryOptions[] = {
    {'c', "chunks", kNone, "learned rules"},          {'d', "default", kNone, "default rules"},
    {'j', "justifications", kNone, "justifications"}, {'T', "templates", kNone, "templates"},
    {'u', "user", kNone, "ordinary rules"},
};

bool MemoryUsage(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kMemoryOptions, parsed)) return false;
  if (parsed.arguments.size() > 1) return call.Fail("Syntax: memories [options] [number]\nmemories production_name");
  const auto count = [&](ProductionId id) { return call.agent().rete().CountTokens(id, false); };
  std::size_t limit = 0;
  if (!parsed.arguments.empty()) {
    const std::string& word = parsed.arguments.front().text;
    const auto number = ParseLeadingInteger(word);
    if (!number) {
      if (!parsed.options.empty()) {
        return call.Fail("Do not specify production type when specifying a production name.");
      }
      const ProductionId id = FindRule(call.agent(), word);
      if (id == ProductionId::kNone) return call.Fail("Production not found.");
      PrintCounts(call, {{count(id), RuleName(call.agent(), call.agent().production(id))}});
      call.Out(CrowdText(call.agent(), id));
      return true;
    }
    if (*number <= 0) return call.Fail("Expected positive integer.");
    limit = static_cast<std::size_t>(*number);
  }
  const bool all = parsed.options.empty();
  const auto wanted = [&](const Production& rule) {
    switch (rule.type) {
      case ProductionType::kUser:
        return all || parsed.Has('u');
      case ProductionType::kDefault:
        return all || parsed.Has('d');
      case ProductionType::kChunk:
        return all || parsed.Has('c');
      case ProductionType::kJustification:
        return all || parsed.Has('j');
      case ProductionType::kTemplate:
        return all || parsed.Has('T');
    }
    return false;
  };
  // A justification has exactly one match.
  std::vector<Counted> lines =
      CountRules(call,
                 {ProductionType::kUser, ProductionType::kDefault, ProductionType::kChunk,
                  ProductionType::kJustification, ProductionType::kTemplate},
                 true, wanted, [&](ProductionId id) { return id == ProductionId::kNone ? 1 : count(id); });
  if (lines.empty()) return call.Fail("Production not found.");
  SortCounts(lines, limit);
  PrintCounts(call, lines);
  for (const ProductionId id : Selected(call, parsed)) call.Out(CrowdText(call.agent(), id));
  return true;
}

constexpr OptionSpec kMatchesOptions[] = {
    {'a', "assertions", kNone, "rules about to fire"},
    {'r', "retractions", kNone, "matches about to retract"},
    {'n', "names", kNone, "names only"},
    {'c', "count", kNone, "counts only"},
    {'t', "timetags", kNone, "with time tags"},
    {'w', "wmes", kNone, "with elements"},
};

bool Matches(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kMatchesOptions, parsed)) return false;
  if (parsed.arguments.size() > 1) return call.Fail("Error.");
  if (!parsed.arguments.empty() && (parsed.Has('a') || parsed.Has('r'))) return call.Fail("Error.");
  WmeDetail detail = WmeDetail::kNone;
  bool assertions = true, retractions = true;  // If both options are given, the last one counts.
  for (const ParsedOption& option : parsed.options) {
    if (option.letter == 'a' || option.letter == 'r') {
      assertions = option.letter == 'a';
      retractions = !assertions;
    }
    if (option.letter == 'n' || option.letter == 'c') detail = WmeDetail::kNone;
    if (option.letter == 't') detail = WmeDetail::kTimetags;
    if (option.letter == 'w') detail = WmeDetail::kFull;
  }
  PrintStream::Capture capture(call.stream(), &call.result.text);
  if (parsed.arguments.empty()) {
    PrintMatchSet(call.stream(), call.agent(), assertions, retractions, detail, call.result.structured);
    return true;
  }
  const std::string& word = parsed.arguments.front().text;
  const ProductionId id = FindRule(call.agent(), word);
  if (id == ProductionId::kNone) return call.Fail("Production not found: " + word);
  PrintPartialMatches(call.stream(), call.agent(), id, detail, call.result.structured);
  return true;
}

bool OptimizeAttribute(CommandCall& call) {
  if (call.words.size() > 3) return call.Fail("Too many parameters");
  kernel::Agent& agent = call.agent();
  if (call.words.size() == 1) {
    std::map<std::string, std::int64_t> all;
    for (const auto& [attribute, count] : agent.expected_values().all()) {
      all[ToString(agent.symbols(), attribute)] = count;
    }
    if (all.empty()) call.Out("No optimized attributes found.");
    call.Out("Value\tSymbol\n");
    for (const auto& [symbol, value] : all) {
      call.Out(fmt::format("{}\t{}\n", value, symbol));
    }
    return true;
  }
  std::int64_t value = 10;
  if (call.words.size() == 3) {
    const auto number = ParseLeadingInteger(call.words[2].text);
    if (!number || *number < 1 || *number > 1000000000) return call.Fail("Expected non-negative integer.");
    value = *number;
  }
  const kernel::SymbolTable::PinScope pin(agent.mutable_symbols());
  agent.mutable_expected_values().Set(MakeConstant(agent, call.words[1].text), value);
  return true;
}

constexpr SubcommandInfo kProductionSubcommandList[] = {
    {"break", "[RULE]", "stops runs when a rule matches", kBreakOptions, Break},
    {"excise", "[RULE]", "removes rules", kExciseOptions, Excise},
    {"find", "PATTERN", "finds rules by what they test", kFindOptions, Find},
    {"firing-counts", "[N | RULE]", "how often rules fired", kCountOptions, FiringCounts},
    {"matches", "[RULE]", "how far a rule matches, or what is about to fire", kMatchesOptions, Matches},
    {"memory-usage", "[N | RULE]", "how many partial matches rules hold", kMemoryOptions, MemoryUsage},
    {"optimize-attribute",
     "[ATTRIBUTE [N]]",
     "how many values of an attribute the matcher expects",
     {},
     OptimizeAttribute},
    {"watch", "[RULE]", "shows firings of a rule at any trace level", kWatchOptions, Watch},
};

}  // namespace

const std::span<const SubcommandInfo> kProductionSubcommands = kProductionSubcommandList;

bool CommandProduction(CommandCall& call) {
  if (call.words.size() < 2) return ProductionOverview(call);
  return RunSubcommand(call, {.also_known = "bqvxyz"});
}

}  // namespace soarbox::cli
