// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/descriptions.h"

#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/match/rete.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

WmeInfo Descriptions::Describe(WmeId id) const {
  const Wme& wme = uses_.memory.wme(id);
  return {id, wme.timetag, wme.id, wme.attribute, wme.value, wme.acceptable};
}

GoalInfo Descriptions::Describe(const Goal& goal) const {
  return {goal.id, goal.level, goal.impasse, goal.impasse_on_operator, OperatorOf(goal)};
}

Symbol Descriptions::OperatorOf(const Goal& goal) const {
  const WmeId selected = uses_.memory.slot(goal.operator_slot).wmes;
  return selected == WmeId::kNone ? Symbol() : uses_.memory.wme(selected).value;
}

std::string_view Descriptions::ProductionName(InstantiationId id) const {
  const Instantiation& instantiation = uses_.instantiations[id];
  if (instantiation.justification != Instantiation::kNoJustification) {
    return uses_.justifications.Name(instantiation.justification);
  }
  if (instantiation.production == ProductionId::kNone) return kNoRule;
  const ProductionPtr& rule = uses_.rete.production(instantiation.production);
  return rule == nullptr ? std::string_view("[excised]") : std::string_view(rule->name);
}

FiringInfo Descriptions::DescribeInstantiation(InstantiationId id) const {
  const Instantiation& instantiation = uses_.instantiations[id];
  FiringInfo info;
  info.instantiation = id;
  info.production = instantiation.production;
  if (instantiation.production != ProductionId::kNone)
    info.rule = uses_.rete.production(instantiation.production).get();
  info.name = ProductionName(id);
  info.goal = instantiation.goal;
  info.level = instantiation.level;
  if (instantiation.match != MatchId::kNone) info.wmes = uses_.rete.Wmes(instantiation.match);
  return info;
}

}  // namespace soarbox::kernel
