// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/inspection_learning.h"

#include "cli/object_printer.h"
#include "cli/stack_printer.h"
#include "kernel/learn/explanation_log.h"
#include "kernel/rules/print_production.h"

namespace soarbox {
namespace {

using kernel::ExplainedRule;

mind::TripleFact ReadCondition(const ExplainedRule::Condition& from) {
  mind::TripleFact to;
  to.negated = from.negated;
  to.id = from.id.text;
  if (from.negated) return to;
  to.attribute = from.attribute.text;
  to.value = from.value.text;
  if (from.acceptable) to.sign = "+";
  if (!from.id.value.empty()) to.met = from.id.value + " ^" + from.attribute.value + " " + from.value.value;
  to.above = from.operational;
  to.creator = from.creator;
  to.path = from.path;
  return to;
}

mind::TripleFact ReadAction(const ExplainedRule::Action& from) {
  mind::TripleFact to;
  to.id = from.id.text;
  to.attribute = from.attribute.text;
  to.value = from.value.text;
  to.referent = from.referent.text;
  to.sign = kernel::PreferenceSign(from.type);
  to.met = from.id.value + " ^" + from.attribute.value + " " + from.value.value;
  return to;
}

void ReadTriples(const std::vector<ExplainedRule::Condition>& conditions,
                 const std::vector<ExplainedRule::Action>& actions, std::vector<mind::TripleFact>& to_conditions,
                 std::vector<mind::TripleFact>& to_actions) {
  for (const ExplainedRule::Condition& condition : conditions) to_conditions.push_back(ReadCondition(condition));
  for (const ExplainedRule::Action& action : actions) to_actions.push_back(ReadAction(action));
}

/// The constant that a test asks for; none if it asks for a variable or for several things.
kernel::Symbol ConstantIn(const kernel::Test& test) {
  const auto of = [](const kernel::Test& one) {
    const bool is_constant = one.kind == kernel::TestKind::kEqual && !one.referent().IsVariable();
    return is_constant ? one.referent() : kernel::Symbol();
  };
  for (const kernel::Test& part : test.parts())
    if (const kernel::Symbol constant = of(part)) return constant;
  return of(test);
}

}  // namespace

std::string ConstantsOf(const kernel::Agent& agent, const kernel::Production& production) {
  std::string text;
  int count = 0;
  for (const kernel::Condition& condition : production.conditions) {
    if (condition.kind != kernel::ConditionKind::kPositive) continue;
    const kernel::Symbol attribute = ConstantIn(condition.attribute), value = ConstantIn(condition.value);
    if (!attribute || !value) continue;
    const std::string name = cli::SymbolText(agent, attribute);
    if (name == "type" || name == "impasse" || name == "superstate") continue;
    if (++count > kMostConstants) return text + " ...";
    text += (text.empty() ? "^" : " ^") + name + " " + cli::SymbolText(agent, value);
  }
  return text;
}

std::vector<mind::LearnedRuleFact> InspectLessons(const kernel::Agent& agent, bool whole, std::string_view rule) {
  std::vector<mind::LearnedRuleFact> learned_rules;
  for (const ExplainedRule& from : agent.explanations().noted()) {
    if (!rule.empty() && from.name != rule) continue;
    mind::LearnedRuleFact& to = learned_rules.emplace_back();
    to.rule = from.name;
    to.decision = from.decision;
    to.level = from.level;
    to.state = from.state;
    to.superstate = from.superstate;
    to.impasse = cli::ImpasseName(from.impasse);
    to.attribute = from.on_operator ? "operator" : "state";
    to.operator_name = from.op;
    to.base = from.base;
    to.local_negation = from.local_negation;
    to.long_term_memory = from.long_term_memory;
    to.repaired = from.repaired;
    if (!whole) {
      // The rule's purpose: its actions, and the conditions that name operators.
      for (const ExplainedRule::Action& action : from.actions) to.actions.push_back(ReadAction(action));
      for (const ExplainedRule::Condition& condition : from.conditions) {
        if (condition.attribute.text == "name") to.conditions.push_back(ReadCondition(condition));
      }
      continue;
    }
    ReadTriples(from.conditions, from.actions, to.conditions, to.actions);
    for (const ExplainedRule::Firing& firing : from.firings) {
      mind::FiringFact& read = to.firings.emplace_back();
      read.serial = firing.serial;
      read.rule = firing.rule;
      read.level = firing.level;
      read.made_result = firing.made_result;
      ReadTriples(firing.conditions, firing.actions, read.conditions, read.actions);
    }
  }
  return learned_rules;
}

}  // namespace soarbox
