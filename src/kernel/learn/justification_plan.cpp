// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/justification_plan.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "kernel/decide/instantiation_table.h"
#include "kernel/learn/draft_tests.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

namespace {

using Part = FiringReader::Part;
using Said = FiringReader::Term;

}  // namespace

std::uint16_t JustificationPlanner::ClassOf(IdentityGraph::Node node) const {
  if (node == IdentityGraph::kNone || analysis_.graph().literal(node)) return IdentityPlan::kLiteral;
  const auto found = class_of_.find(analysis_.graph().Root(node));
  return found == class_of_.end() ? IdentityPlan::kLiteral : found->second;
}

std::pair<std::uint16_t, bool> JustificationPlanner::Classify(IdentityGraph::Node node, std::uint16_t next) {
  if (node == IdentityGraph::kNone || analysis_.graph().literal(node)) return {IdentityPlan::kLiteral, false};
  const auto [place, is_new] = class_of_.try_emplace(analysis_.graph().Root(node), next);
  return {place->second, is_new};
}

IdentityPlan JustificationPlanner::Plan(const Explanation& explanation) {
  IdentityPlan plan;
  class_of_.clear();
  for (const Explanation::Ground& ground : explanation.grounds) {
    for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
      const IdentityGraph::Node node = analysis_.OfGround(ground, field);
      const auto [known, is_new] = Classify(node, plan.bound());
      if (is_new) {
        plan.first.push_back(static_cast<std::uint16_t>(plan.of_field.size()));
        plan.variables.emplace_back();
      }
      plan.of_field.push_back(known);
    }
  }
  std::uint16_t next = plan.bound();
  for (const PreferenceId result : explanation.results) {
    const Preference& preference = uses_.memory.preference(result);
    for (const Part part : {Part::kId, Part::kAttribute, Part::kValue, Part::kReferent}) {
      const Said term = reader_.TermOf(result, part);
      const IdentityGraph::Node node = analysis_.OfTerm(term, preference.instantiation);
      const auto [known, is_new] = Classify(node, next);
      if (is_new) ++next;
      plan.of_action.push_back(known);
    }
  }
  return plan;
}

ValueDraft JustificationPlanner::MoveFunction(const RhsValue& function, InstantiationId firing,
                                              const IdentityPlan& plan) {
  ValueDraft out;
  out.kind = RhsValueKind::kFunction;
  out.index = function.function_index();
  for (const RhsValue& argument : function.arguments()) {
    ValueDraft copy;
    if (argument.kind == RhsValueKind::kFunction) {
      copy = MoveFunction(argument, firing, plan);
    } else if (argument.kind == RhsValueKind::kBound) {
      const Wme& wme = uses_.memory.wme(uses_.instantiations.Trace(firing)[argument.site().positive_condition].wme);
      copy.symbol = FieldOf(wme, argument.site().field);
      const IdentityGraph::Node node = analysis_.OfClass(firing, reader_.ClassOf(argument, firing));
      if (const std::uint16_t known = ClassOf(node); known < plan.bound()) {
        const std::uint16_t place = plan.first[known];
        copy.kind = RhsValueKind::kBound;
        copy.site = {static_cast<std::uint16_t>(place / 3u), static_cast<Field>(place % 3u)};
      }
    } else {
      copy.symbol = argument.symbol();
    }
    out.arguments.Add(arena_.New(copy));
  }
  return out;
}

ProductionPtr JustificationPlanner::Functions(const Explanation& explanation, const IdentityPlan& plan) {
  arena_.Clear();
  RuleDraft rule;
  bool any = false;
  for (const PreferenceId result : explanation.results) {
    const Preference& preference = uses_.memory.preference(result);
    ActionDraft* const action = arena_.New<ActionDraft>();
    action->preference = PreferenceType::kAcceptable;
    action->id.symbol = preference.id;
    action->attribute.symbol = preference.attribute;
    action->value.symbol = preference.value;
    for (const auto& [part, value, symbol] : {std::tuple{Part::kAttribute, &action->attribute, preference.attribute},
                                              std::tuple{Part::kValue, &action->value, preference.value}}) {
      const Said term = reader_.TermOf(result, part);
      if (term.kind != Said::Kind::kFunction || symbol.IsIdentifier()) continue;
      *value = MoveFunction(*term.function, preference.instantiation, plan);
      any = true;
    }
    rule.actions.Add(action);
  }
  return any ? Production::Make(rule) : ProductionPtr();
}

std::vector<std::vector<std::uint16_t>> JustificationPlanner::NegatedClasses(const Explanation& explanation) {
  arena_.Clear();
  std::vector<std::vector<std::uint16_t>> all;
  for (const Explanation::Negation& negation : explanation.negations) {
    std::vector<std::uint16_t>& classes = all.emplace_back();
    ConditionDraft draft =
        negation.source != nullptr ? ToDraft(*negation.source, arena_) : Copy(negation.literal, arena_);
    std::size_t number = 0;
    ForEachTest(draft, [&](const TestDraft& test) {
      std::uint16_t bound = IdentityPlan::kLiteral;
      if (negation.source == nullptr) {
        if (number < negation.classes.size()) bound = negation.classes[number];
      } else if (test.referent.IsVariable()) {
        bound = reader_.Plan(negation.firing).ClassOf(test.referent);
      }
      ++number;
      classes.push_back(bound == IdentityPlan::kLiteral ? bound : ClassOf(analysis_.OfClass(negation.firing, bound)));
    });
  }
  return all;
}

std::vector<IdentityPlan::KeptTest> JustificationPlanner::Tests(const Explanation& explanation, bool counts) {
  std::vector<IdentityPlan::KeptTest> kept;
  const auto keep = [&](std::size_t number, Field field, TestKind kind, Symbol referent, IdentityGraph::Node node,
                        std::span<const Symbol> disjuncts, bool of_literal) {
    IdentityPlan::KeptTest test;
    test.of_literal = of_literal;
    test.condition = static_cast<std::uint16_t>(number);
    test.field = field;
    test.kind = kind;
    test.referent = referent;
    test.referent_class = ClassOf(node);
    // An object that is in no condition may be removed before the justification is.
    if (referent.IsIdentifier() && test.referent_class == IdentityPlan::kLiteral) return;
    test.disjuncts.assign(disjuncts.begin(), disjuncts.end());
    kept.push_back(std::move(test));
  };
  for (std::size_t n = 0; n < explanation.grounds.size(); ++n) {
    const Explanation::Ground& ground = explanation.grounds[n];
    if (ground.firing == InstantiationId::kNone) continue;
    for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
      const IdentityGraph::Node tested = analysis_.OfGround(ground, field);
      const bool literal = tested == IdentityGraph::kNone || analysis_.graph().literal(tested);
      carried_.ForEach(ground.firing, ground.condition, field, [&](const CarriedTest& test) {
        if (carried_.MayRise(test))
          keep(n, field, test.kind, test.referent, test.referent_node, test.disjuncts, literal);
      });
    }
  }
  // Tests of local conditions are assigned to the field where their identity first occurs.
  carried_.Collect(explanation, constraints_);
  const auto place_of = [&](IdentityGraph::Node node) -> std::pair<std::size_t, Field> {
    if (node == IdentityGraph::kNone || analysis_.graph().literal(node)) return {explanation.grounds.size(), {}};
    for (std::size_t n = 0; n < explanation.grounds.size(); ++n) {
      for (const Field field : {Field::kId, Field::kAttribute, Field::kValue}) {
        const IdentityGraph::Node here = analysis_.OfGround(explanation.grounds[n], field);
        if (here != IdentityGraph::kNone && analysis_.graph().Root(here) == analysis_.graph().Root(node)) {
          return {n, field};
        }
      }
    }
    return {explanation.grounds.size(), {}};
  };
  const auto of_conditions = static_cast<std::ptrdiff_t>(kept.size());
  std::uint64_t placed = 0;
  for (const CarriedTest& test : constraints_) {
    const auto here = place_of(test.tested);
    if (here.first < explanation.grounds.size()) {
      keep(here.first, here.second, test.kind, test.referent, test.referent_node, test.disjuncts, false);
      ++placed;
      continue;
    }
    const auto there = place_of(test.referent_node);
    if (there.first < explanation.grounds.size() && test.kind != TestKind::kDisjunction) {
      keep(there.first, there.second, TurnedRound(test.kind), test.value, IdentityGraph::kNone, {}, false);
      ++placed;
    }
  }
  // As in a learned rule, they come before the conditions' own tests, the last one first.
  std::rotate(kept.begin(), kept.begin() + of_conditions, kept.end());
  std::reverse(kept.begin(), kept.end() - of_conditions);
  if (counts) {
    uses_.statistics.constraints_found += constraints_.size();
    uses_.statistics.constraints_placed += placed;
  }
  return kept;
}

}  // namespace soarbox::kernel
