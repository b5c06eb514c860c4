// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/decide/instantiation_table.h"
#include "kernel/learn/draft_tests.h"
#include "kernel/learn/explanation.h"
#include "kernel/learn/firing_reader.h"
#include "kernel/learn/identity_analysis.h"
#include "kernel/learn/identity_plan.h"
#include "kernel/memory/working_memory.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

class Justifier;

/// A test of a local condition that the learned rule must contain, too. It compares one identity with another one or
/// with a constant.
struct CarriedTest {
  InstantiationId firing = InstantiationId::kNone;
  std::uint16_t condition = 0;
  Field field = Field::kValue;
  TestKind kind = TestKind::kBlank;
  IdentityGraph::Node tested = IdentityGraph::kNone;
  IdentityGraph::Node referent_node = IdentityGraph::kNone;  ///< kNone: compared with `referent`.
  Symbol value, referent;                                    ///< The values that matched.
  std::vector<Symbol> disjuncts;
  bool placed = false;
};

/// The tests, other than equality, that firings applied to elements, and that a rule learned from them must apply, too.
class CarriedTests {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    const WorkingMemory& memory;
    const InstantiationTable& instantiations;
    const Justifier& justifier;
  };
  CarriedTests(const Uses& uses, FiringReader& reader, IdentityAnalysis& analysis)
      : uses_(uses), reader_(reader), analysis_(analysis) {}

  /// Calls visit(CarriedTest) for each test, other than equality, of a field of a condition of a firing. The tests are
  /// those of its rule, or, for a justification, those of the reasoning that it summarizes.
  template <typename Visit>
  void ForEach(InstantiationId firing, std::uint16_t condition, Field field, Visit&& visit);
  /// Returns false if the test compares with an object of the firing's own state, which the learned rule cannot access.
  bool MayRise(const CarriedTest& test) const { return IsKnownAbove(test.firing, test.referent); }
  /// Returns false if the symbol is an object of the firing's own state or of a lower one.
  bool IsKnownAbove(InstantiationId firing, Symbol symbol) const;
  /// Appends the tests of all conditions that tested elements of the substate, in the order in which the conditions
  /// were visited.
  void Collect(const Explanation& explanation, std::vector<CarriedTest>& out);

 private:
  /// The tests, other than equality, of a justification; none for other instantiations.
  const std::vector<IdentityPlan::KeptTest>& KeptTests(const Instantiation& instantiation) const;

  Uses uses_;
  FiringReader& reader_;
  IdentityAnalysis& analysis_;
};

template <typename Visit>
void CarriedTests::ForEach(InstantiationId firing, std::uint16_t condition, Field field, Visit&& visit) {
  const Instantiation& instantiation = uses_.instantiations[firing];
  if (!instantiation.has_identities) return;
  const bool is_rule = reader_.Rule(firing) != nullptr;
  if (is_rule && !reader_.TestedBy(firing, condition).Carries(field)) return;
  CarriedTest test;
  test.firing = firing;
  test.condition = condition;
  test.field = field;
  if (is_rule) {
    const Condition& tested = *reader_.TestedBy(firing, condition).condition;
    const IdentityPlan& plan = reader_.Plan(firing);
    const auto visit_part = [&](const Test& part) {
      if (!IsCarried(part.kind)) return;
      test.kind = part.kind;
      test.referent = part.referent();
      test.referent_node = IdentityGraph::kNone;
      test.disjuncts.assign(part.disjuncts().begin(), part.disjuncts().end());
      if (test.referent.IsVariable()) {
        const std::uint16_t referent = plan.ClassOf(test.referent);
        if (referent == IdentityPlan::kLiteral) return;
        test.referent = ValueOfClass(plan, referent, uses_.instantiations.Trace(firing), uses_.memory);
        test.referent_node = analysis_.OfClass(firing, referent);
        if (const std::uint16_t own = plan.ClassOf(condition, field);
            own != IdentityPlan::kLiteral && reader_.IsTurned(firing, condition, field, part)) {
          test.referent_node = analysis_.OfClass(firing, own);
        }
      }
      visit(test);
    };
    ForEachTest(field == Field::kId          ? tested.id
                : field == Field::kAttribute ? tested.attribute
                                             : tested.value,
                visit_part);
    return;
  }
  for (const IdentityPlan::KeptTest& kept : KeptTests(instantiation)) {
    if (kept.condition != condition || kept.field != field || kept.of_literal) continue;
    test.kind = kept.kind;
    test.referent = kept.referent;
    test.referent_node = analysis_.OfClass(firing, kept.referent_class);
    test.disjuncts = kept.disjuncts;
    visit(test);
  }
}

}  // namespace soarbox::kernel
