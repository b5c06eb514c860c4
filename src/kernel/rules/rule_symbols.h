// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// Calls visit(symbol) for each constant, identifier and variable in a part of a rule.
template <typename Visit>
void ForEachSymbol(const Test& test, Visit&& visit) {
  if (test.referent()) visit(test.referent());
  for (const Symbol symbol : test.disjuncts()) visit(symbol);
  for (const Test& part : test.parts()) ForEachSymbol(part, visit);
}

template <typename Visit>
void ForEachSymbol(const Condition& condition, Visit&& visit) {
  for (const Condition& inner : condition.conditions()) ForEachSymbol(inner, visit);
  if (condition.kind == ConditionKind::kConjunctiveNegation) return;
  for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) ForEachSymbol(*test, visit);
}

template <typename Visit>
void ForEachSymbol(const RhsValue& value, Visit&& visit) {
  if (value.symbol()) visit(value.symbol());
  for (const RhsValue& argument : value.arguments()) ForEachSymbol(argument, visit);
}

template <typename Visit>
void ForEachSymbol(const Production& rule, Visit&& visit) {
  for (const Condition& condition : rule.conditions) ForEachSymbol(condition, visit);
  for (const Action& action : rule.actions) {
    ForEachSymbol(action.value, visit);
    if (action.is_function_call) continue;
    ForEachSymbol(action.id, visit);
    ForEachSymbol(action.attribute, visit);
    if (action.HasReferent()) ForEachSymbol(action.referent, visit);
  }
}

}  // namespace soarbox::kernel
