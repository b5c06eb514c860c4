// SPDX-License-Identifier: BSD-2-Clause
#include "rule_reading/rule_reading.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "kernel/base/symbol_table.h"
#include "kernel/rules/functions/builtin_functions.h"
#include "kernel/rules/parser.h"
#include "kernel/rules/print_production.h"
#include "kernel/rules/production.h"
#include "rule_reading/nearest_function.h"

namespace soarbox::rule_reading {
namespace {

using kernel::Condition;
using kernel::ConditionKind;
using kernel::RhsValue;
using kernel::RhsValueKind;
using kernel::Test;
using kernel::TestKind;

class FactWriter {
 public:
  explicit FactWriter(const kernel::SymbolTable& symbols) : symbols_(symbols) {}

  mind::RuleFacts facts;

  void AddConditions(std::span<const Condition> conditions, int group) {
    for (const Condition& condition : conditions) {
      if (condition.kind == ConditionKind::kConjunctiveNegation) {
        // A nested group belongs to the outer one.
        AddConditions(condition.conditions(), group > 0 ? group : ++groups_);
        continue;
      }
      mind::RuleConditionFact& fact = facts.conditions.emplace_back();
      fact.id = IdOf(condition.id);
      fact.attribute = TextOf(condition.attribute);
      fact.value = TextOf(condition.value);
      fact.acceptable = condition.tests_acceptable;
      fact.negated = group > 0 || condition.kind == ConditionKind::kNegative;
      fact.group = group;
    }
  }

  /// Marks all conditions of a state's variable, because the word `state` occurs once per variable.
  void MarkStates() {
    for (mind::RuleConditionFact& condition : facts.conditions) condition.on_state = states_.contains(condition.id);
  }

  void AddAction(const kernel::Action& action) {
    facts.acts = true;
    if (action.is_function_call) return AddCalls(action.value);
    mind::RuleActionFact& fact = facts.actions.emplace_back();
    fact.id = TextOf(action.id);
    fact.attribute = TextOf(action.attribute);
    fact.value = TextOf(action.value);
    fact.sign = kernel::PreferenceSign(action.preference);
    if (action.HasReferent()) fact.referent = TextOf(action.referent);
    for (const RhsValue* value : {&action.id, &action.attribute, &action.value}) AddCalls(*value);
    if (action.HasReferent()) AddCalls(action.referent);
  }

 private:
  /// Writes the test for equality first, as authors do; the kernel has another order.
  std::string TextOf(const Test& test) const {
    std::string text;
    if (test.kind == TestKind::kConjunction) {
      // Literal tests, which only learning uses, do not affect the match.
      const auto counts = [](const Test& part) { return part.kind != TestKind::kLiteral; };
      for (const Test& part : test.parts())
        if (part.kind == TestKind::kEqual) text += " " + TextOf(part);
      for (const Test& part : test.parts())
        if (part.kind != TestKind::kEqual && counts(part)) text += " " + TextOf(part);
      return std::ranges::count_if(test.parts(), counts) == 1 ? text.substr(1) : "{" + text + " }";
    }
    kernel::AppendTest(text, symbols_, test);
    return text;
  }

  std::string TextOf(const RhsValue& value) const {
    std::string text;
    kernel::AppendRhsValue(text, symbols_, value);
    return text;
  }

  /// The test of an identifier without the word `state`. Several tests are kept together.
  std::string IdOf(const Test& id) {
    std::vector<std::string> tests;
    bool is_state = false;
    const auto add = [&](const Test& test) {
      if (test.kind == TestKind::kState) {
        is_state = true;
      } else if (test.kind != TestKind::kImpasse) {
        tests.insert(test.kind == TestKind::kEqual ? tests.begin() : tests.end(), TextOf(test));
      }
    };
    if (id.kind == TestKind::kConjunction) {
      for (const Test& part : id.parts()) add(part);
    } else {
      add(id);
    }
    std::string text;
    for (const std::string& test : tests) text += (text.empty() ? "" : " ") + test;
    if (tests.size() > 1) text = "{ " + text + " }";
    if (is_state) states_.insert(text);
    return text;
  }

  void AddCalls(const RhsValue& value) {
    if (value.kind != RhsValueKind::kFunction) return;
    mind::RuleCallFact call;
    call.function = kernel::BuiltinFunctions()[value.function_index()].name;
    for (const RhsValue& argument : value.arguments()) call.arguments.push_back(TextOf(argument));
    facts.calls.push_back(std::move(call));
    for (const RhsValue& argument : value.arguments()) AddCalls(argument);
  }

  const kernel::SymbolTable& symbols_;
  std::set<std::string> states_;
  int groups_ = 0;
};

/// Adds bars to the variables with which conditions compare: "> <h>" is converted to "> |<h>|".
std::string WithComparedInBars(std::string_view text) {
  constexpr std::string_view kRelations[] = {"<", ">", "<=", ">=", "<>", "<=>"};
  std::string done;
  bool quoted = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find_first_of("<> \t\n|^(){}", at + 1);
    const bool is_variable =
        !quoted && text[at] == '<' && end != std::string_view::npos && end > at + 1 && text[end] == '>';
    if (!is_variable) {
      if (text[at] == '\\' && quoted && at + 1 < text.size()) done += text[at++];
      if (text[at] == '|') quoted = !quoted;
      done += text[at++];
      continue;
    }
    const std::size_t last = done.find_last_not_of(" \t\n");
    const std::string before = last == std::string::npos ? "" : done.substr(0, last + 1);
    const std::size_t word = before.find_last_of(" \t\n({") + 1;  // 0 if there is none.
    const bool is_compared = std::ranges::find(kRelations, before.substr(word)) != std::end(kRelations);
    const std::string variable(text.substr(at, end + 1 - at));
    done += is_compared ? "|" + variable + "|" : variable;
    at = end + 1;
  }
  return done;
}

/// Removes these bars.
std::string WithoutBarsOfVariables(std::string text) {
  for (std::size_t at = text.find("|<"); at != std::string::npos; at = text.find("|<", at)) {
    const std::size_t end = text.find('|', at + 1);
    if (end == std::string::npos || text[end - 1] != '>') {
      at += 2;
      continue;
    }
    text.erase(end, 1);
    text.erase(at, 1);
  }
  return text;
}

/// Position of the closing brace for braces that are open at `begin`. Braces in bars and in the documentation of a rule
/// do not count.
std::size_t EndOfBraces(std::string_view text, std::size_t begin) {
  int depth = 1;
  char quote = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == '\\') {
        ++i;
      } else if (c == quote) {
        quote = 0;
      }
    } else if (c == '|' || c == '"') {
      quote = c;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return i;
    }
  }
  return std::string_view::npos;
}

}  // namespace

mind::RuleFacts FactsOf(const kernel::Production& rule, const kernel::SymbolTable& symbols) {
  using Support = mind::RuleFacts::Support;
  FactWriter writer(symbols);
  writer.facts.name = rule.name;
  writer.facts.file = rule.file();
  writer.facts.line = rule.line;
  writer.facts.column = rule.column;
  writer.facts.is_template = rule.type == kernel::ProductionType::kTemplate;
  if (rule.declared_support == kernel::DeclaredSupport::kOSupport) writer.facts.support = Support::kOSupport;
  if (rule.declared_support == kernel::DeclaredSupport::kISupport) writer.facts.support = Support::kISupport;
  writer.AddConditions(rule.conditions, 0);
  writer.MarkStates();
  for (const kernel::Action& action : rule.actions) writer.AddAction(action);
  return std::move(writer.facts);
}

std::vector<mind::RuleFacts> ReadPrintedRules(std::string_view text) {
  constexpr std::string_view kBegin = "sp {";
  std::vector<mind::RuleFacts> rules;
  kernel::SymbolTable symbols;
  // A kernel has loaded these rules, so a function that is not built in belongs to a client.
  kernel::RuleLanguage language;
  language.is_client_function = [](std::string_view) { return true; };
  for (std::size_t at = text.find(kBegin); at != std::string_view::npos; at = text.find(kBegin, at)) {
    const std::size_t begin = at + kBegin.size();
    const std::size_t end = EndOfBraces(text, begin);
    if ((at > 0 && text[at - 1] != '\n') || end == std::string_view::npos) {
      at = begin;
      continue;
    }
    const kernel::ParseOutcome outcome =
        kernel::ParseProduction(text.substr(begin, end - begin), {}, symbols, {}, language);
    if (outcome.production != nullptr) rules.push_back(FactsOf(*outcome.production, symbols));
    at = end;
  }
  return rules;
}

std::vector<mind::RuleConditionFact> ReadPrintedConditions(std::string_view text) {
  // A rule must begin with a state, but conditions alone may not. Variables in comparisons may be bound by other
  // conditions; the parser would drop such comparisons, but it keeps comparisons with a constant.
  constexpr std::string_view kState = "<printed-conditions*1>";
  const std::string body = "conditions (state " + std::string(kState) + " ^superstate) " + WithComparedInBars(text) +
                           " --> (" + std::string(kState) + " ^read yes)";
  kernel::SymbolTable symbols;
  const kernel::ParseOutcome outcome = kernel::ParseProduction(body, {}, symbols);
  if (outcome.production == nullptr) return {};
  std::vector<mind::RuleConditionFact> conditions = FactsOf(*outcome.production, symbols).conditions;
  std::erase_if(conditions, [&](const mind::RuleConditionFact& one) { return one.id == kState; });
  for (mind::RuleConditionFact& one : conditions) one.value = WithoutBarsOfVariables(std::move(one.value));
  return conditions;
}

std::string_view NearestFunction(std::string_view name) {
  return kernel::NearestFunction(name);
}

}  // namespace soarbox::rule_reading
