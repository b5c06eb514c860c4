// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "cli/command.h"
#include "cli/knowledge_printer.h"
#include "cli/lookup.h"
#include "cli/object_printer.h"
#include "cli/printed_rule.h"
#include "cli/session.h"
#include "cli/stack_printer.h"
#include "cli/wme_pattern.h"

namespace soarbox::cli {
namespace {

using kernel::ProductionId;
using kernel::ProductionType;
using kernel::Symbol;

constexpr OptionSpec kPrintOptionList[] = {
    {'a', "all", OptionArgument::kNone, "names of all rules"},
    {'c', "chunks", OptionArgument::kNone, "rules that were learned"},
    {'d', "depth", OptionArgument::kRequired, "how many levels of objects to print"},
    {'D', "defaults", OptionArgument::kNone, "rules marked :default"},
    {'e', "exact", OptionArgument::kNone, "only the elements that a pattern matches, not their objects"},
    {'f', "full", OptionArgument::kNone, "whole rules instead of names"},
    {'F', "filename", OptionArgument::kNone, "with the file that a rule came from"},
    {'g', "gds", OptionArgument::kNone, "goal dependency sets"},
    {'i', "internal", OptionArgument::kNone, "one line per element or condition, with time tags"},
    {'j', "justifications", OptionArgument::kNone, "justifications"},
    {'n', "name", OptionArgument::kNone, "names instead of whole rules"},
    {'o', "operators", OptionArgument::kNone, "only the operators of the stack"},
    {'r', "rl", OptionArgument::kNone, "rules of reinforcement learning"},
    {'s', "stack", OptionArgument::kNone, "the goal stack"},
    {'S', "states", OptionArgument::kNone, "only the states of the stack"},
    {'t', "tree", OptionArgument::kNone, "objects below the element that leads to them"},
    {'T', "template", OptionArgument::kNone, "rules marked :template"},
    {'u', "user", OptionArgument::kNone, "rules of no special type"},
    {'v', "varprint", OptionArgument::kNone, "identifiers in angle brackets"},
};

/// The format of a list of rules.
struct RuleListStyle {
  bool full = false;      ///< Complete rules instead of names.
  bool internal = false;  ///< One condition per line.
  bool file = false;      ///< With the file that the rule came from.
};

std::string FileOf(const kernel::Production& rule) {
  return rule.file().empty() ? "_unknown_" : rule.file();
}

void PrintRule(CommandCall& call, const kernel::Production& rule, const RuleListStyle& style) {
  if (style.full) {
    if (style.file) call.stream().Print("# source file: " + FileOf(rule) + "\n");
    call.stream().Print(RuleText(call.agent(), rule, style.internal));
    return;
  }
  if (style.file) call.stream().Print(FileOf(rule) + ": ");
  call.stream().Print(RuleName(call.agent(), rule) + " " + LearnedValueText(call.agent(), rule) + "\n");
}

/// Lists rules by type, in Soar's order of types.
void PrintRules(CommandCall& call, const ParsedWords& parsed, const RuleListStyle& style) {
  struct Listed {
    char letter;
    ProductionType type;
  };
  constexpr Listed kTypes[] = {
      {'D', ProductionType::kDefault},       {'u', ProductionType::kUser},  {'T', ProductionType::kTemplate},
      {'j', ProductionType::kJustification}, {'c', ProductionType::kChunk},
  };
  bool any_type = false;
  for (const Listed& listed : kTypes) any_type = any_type || parsed.Has(listed.letter);
  const bool only_rl = parsed.Has('r') && !any_type;
  for (const Listed& listed : kTypes) {
    const bool wanted = parsed.Has('a') || !any_type || parsed.Has(listed.letter);
    if (!wanted) continue;
    if (listed.type == ProductionType::kJustification) {
      if (only_rl && !parsed.Has('a')) continue;
      const std::vector<kernel::ProductionPtr> rules = call.agent().Justifications();
      for (auto rule = rules.rbegin(); rule != rules.rend(); ++rule) PrintRule(call, **rule, style);
      continue;
    }
    for (const ProductionId id : RulesOfType(call.agent(), listed.type)) {
      if (!only_rl || parsed.Has('a') || call.agent().production(id).is_rl) {
        PrintRule(call, call.agent().production(id), style);
      }
    }
  }
}

void PrintGoalDependencySets(CommandCall& call) {
  const kernel::Agent& agent = call.agent();
  PrintStream& out = call.stream();
  const std::string line(60, '*');
  out.Print("********************* Current GDS **************************\n");
  out.Print("stepping thru all wmes in rete, looking for any that are in a gds...\n");
  std::vector<std::pair<std::uint64_t, std::string>> elements;
  const kernel::WmeTable& wmes = agent.memory().wmes();
  for (std::uint32_t i = 0; i < wmes.size(); ++i) {
    const auto id = static_cast<kernel::WmeId>(i);
    const kernel::GoalLevel level = agent.memory().record(id).gds;
    if (!wmes[i].live || level == 0) continue;
    const std::string owner = level <= agent.goals().depth()
                                  ? "  For Goal  " + SymbolText(agent, agent.goals().at(level).id) + "  "
                                  : std::string("  Old GDS value ");
    elements.emplace_back(ArrivalOf(agent.rete(), id), owner + WmeText(agent, id) + "\n");
  }
  // The newest first.
  std::sort(elements.rbegin(), elements.rend());
  for (const auto& [entered, text] : elements) out.Print(text);
  out.Print(line + "\n");
  for (std::size_t level = 1; level <= agent.goals().depth(); ++level) {
    const kernel::Goal& goal = agent.goals().at(static_cast<kernel::GoalLevel>(level));
    out.Print("  For Goal  " + SymbolText(agent, goal.id) + "  ");
    if (!goal.has_gds) {
      out.Print(": No GDS for this goal.\n");
      continue;
    }
    out.Print("\n");
    for (auto wme = goal.gds.rbegin(); wme != goal.gds.rend(); ++wme) {
      out.Print("                " + WmeText(agent, *wme) + "\n");
    }
  }
  out.Print(line + "\n");
}

void PrintPattern(CommandCall& call, const std::string& text, const ObjectStyle& style, bool exact) {
  kernel::Agent& agent = call.agent();
  const WmePattern pattern = ParseWmePattern(agent, text);
  if (!pattern.error.empty()) {
    call.stream().Print(pattern.error);
    return;
  }
  const std::vector<kernel::WmeId> found = FindWmes(agent, pattern, exact && !style.internal);
  if (!exact) {
    for (const kernel::WmeId wme : found) {
      PrintObject(call.stream(), agent, agent.memory().wme(wme).id, style, call.result.structured);
    }
    return;
  }
  Symbol open;
  for (const kernel::WmeId id : found) {
    const kernel::Wme& wme = agent.memory().wme(id);
    AddWmeNode(call.result.structured, agent, id, false);
    if (style.internal) {
      call.stream().Print(WmeText(agent, id) + "\n");
      continue;
    }
    if (wme.id != open) {
      if (open) call.stream().Print(")\n");
      call.stream().Print("(" + SymbolText(agent, wme.id));
      open = wme.id;
    }
    call.stream().Print(" ^" + SymbolText(agent, wme.attribute) + " " + SymbolText(agent, wme.value) +
                        (wme.acceptable ? " +" : ""));
  }
  if (open) call.stream().Print(")\n");
}

void PrintRuleNamed(CommandCall& call, const std::string& word, const RuleListStyle& style) {
  kernel::Agent& agent = call.agent();
  std::string name = word;
  std::erase(name, '|');
  ProductionId id = FindRule(agent, word);
  if (id == ProductionId::kNone) id = FindRule(agent, name);
  if (id != ProductionId::kNone) {
    PrintRule(call, agent.production(id), style);
    return;
  }
  for (const kernel::ProductionPtr& rule : agent.Justifications()) {
    if (rule->name == name) {
      PrintRule(call, *rule, style);
      return;
    }
  }
  call.stream().Print("No production named " + word + "\n");
}

/// Formats an identifier like `print --varprint`.
std::string InBrackets(std::string name, bool as_variable) {
  return as_variable ? "<" + std::move(name) + ">" : name;
}

/// Prints what a single word names: an object, the object of the element with a time tag, a long-term identifier, or a
/// rule.
void PrintThing(CommandCall& call, const std::string& word, const ObjectStyle& style, RuleListStyle rule_style) {
  kernel::Agent& agent = call.agent();
  PrintStream& out = call.stream();
  if (word.front() == '(') {
    PrintPattern(call, word, style, false);
  } else if (word.front() == '@') {
    out.Print(PrintedKnowledge(agent, word, style.depth));
  } else if (word.front() == '<' && word.back() == '>') {
    const Symbol id = FindIdentifier(agent, word);
    if (!IsContextVariable(word))
      out.Print("Expected identifier (or context variable)\n");
    else if (!id)
      out.Print("There is no current " + word + ".\n");
    else
      PrintObject(out, agent, id, style, call.result.structured);
  } else if (const auto name = ParseIdentifierName(word)) {
    const Symbol id = FindIdentifier(agent, word);
    if (id)
      PrintObject(out, agent, id, style, call.result.structured);
    else
      out.Print("There is no identifier " + InBrackets(name->letter + std::to_string(name->number), style.variables) +
                ".\n");
  } else if (const auto timetag = ParseInteger(word)) {
    const kernel::WmeId wme =
        *timetag < 0 ? kernel::WmeId::kNone : agent.memory().FindByTimetag(static_cast<std::uint64_t>(*timetag));
    if (wme == kernel::WmeId::kNone)
      out.Print("No wme " + word + " in working memory.\n");
    else
      PrintObject(out, agent, agent.memory().wme(wme).id, style, call.result.structured);
  } else {
    PrintRuleNamed(call, word, rule_style);
  }
}

}  // namespace

const std::span<const OptionSpec> kPrintOptions = kPrintOptionList;

bool CommandPrint(CommandCall& call) {
  const ParsedWords parsed = ParseOptions(call.words.subspan(1), kPrintOptions);
  PrintStream::Capture capture(call.stream(), &call.result.text);

  ObjectStyle style;
  style.depth = call.session.output().print_depth;
  // A wrong depth is reported before errors in the words after it.
  if (const auto depth = parsed.Argument('d')) {
    const auto number = ParseLeadingInteger(*depth);
    if (!number || *number < 0) return call.Fail("Non-negative depth expected.");
    style.depth = static_cast<int>(std::min<std::int64_t>(*number, 1000000));
  }
  if (!parsed.error.empty()) return call.Fail(parsed.error);
  style.internal = parsed.Has('i');
  style.tree = parsed.Has('t');
  style.variables = parsed.Has('v');
  RuleListStyle rules;
  rules.internal = parsed.Has('i');
  rules.file = parsed.Has('F');
  rules.full = parsed.Has('f') || (rules.internal && !parsed.Has('n'));

  if ((parsed.Has('o') || parsed.Has('S')) && !parsed.Has('s')) {
    return call.Fail("Options --operators (-o) and --states (-S) are only valid when printing the stack.");
  }
  const bool lists = parsed.Has('a') || parsed.Has('c') || parsed.Has('D') || parsed.Has('g') || parsed.Has('j') ||
                     parsed.Has('r') || parsed.Has('s') || parsed.Has('T') || parsed.Has('u');
  if (lists && !parsed.arguments.empty()) {
    return call.Fail(
        "No argument allowed when printing all/chunks/defaults/GDS/justifications/rl/template/user/stack.");
  }
  if (parsed.Has('e') && (parsed.Has('d') || parsed.Has('t'))) {
    return call.Fail("No depth/tree flags allowed when printing exact.");
  }
  if (parsed.arguments.empty() && (parsed.Has('d') || parsed.Has('t'))) {
    return call.Fail("Syntax: print [options] [production_name]\nprint [options] identifier|timetag|pattern");
  }
  if (parsed.Has('s')) {
    PrintStack(call.stream(), call.agent(), !parsed.Has('o') || parsed.Has('S'), !parsed.Has('S') || parsed.Has('o'),
               call.result.structured);
    return true;
  }
  if (parsed.Has('g')) PrintGoalDependencySets(call);
  if (parsed.arguments.empty()) {
    PrintRules(call, parsed, rules);
    return true;
  }

  // Several words, or a word in parentheses, are a pattern.
  std::string text;
  for (const Word& word : parsed.arguments) text += (text.empty() ? "" : " ") + word.text;
  if (text.find('|') != std::string::npos || text.empty()) {
    // As in Soar, bars make the word a name.
    rules.full = parsed.Has('f') || !parsed.Has('n');
    PrintRuleNamed(call, text, rules);
    return true;
  }
  if (text.front() == '(' || (parsed.arguments.size() > 1)) {
    PrintPattern(call, text, style, parsed.Has('e'));
    return true;
  }
  rules.full = parsed.Has('f') || !parsed.Has('n');
  PrintThing(call, text, style, rules);
  return true;
}

}  // namespace soarbox::cli
