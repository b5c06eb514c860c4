// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/base/bump_arena.h"
#include "kernel/learn/carried_tests.h"
#include "kernel/learn/explanation.h"
#include "kernel/learn/identity_plan.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

struct LearnStatistics;

/// Extracts the data on the reasoning for a justification that learning at higher levels needs. With these data, rules
/// learned from the justification are as general as rules learned from the reasoning itself. Call Plan first; the other
/// functions use its results.
class JustificationPlanner {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    const WorkingMemory& memory;
    const InstantiationTable& instantiations;
    LearnStatistics& statistics;
  };
  JustificationPlanner(const Uses& uses, FiringReader& reader, IdentityAnalysis& analysis, CarriedTests& carried)
      : uses_(uses), reader_(reader), analysis_(analysis), carried_(carried) {}

  /// The identity sets as classes: those of each field of the conditions, and of the actions.
  IdentityPlan Plan(const Explanation& explanation);
  /// The tests, other than equality, of its conditions. `counts`: add the tests to the statistics.
  std::vector<IdentityPlan::KeptTest> Tests(const Explanation& explanation, bool counts);
  /// Per negated condition, the classes of its referents, in the order of ForEachTest.
  std::vector<std::vector<std::uint16_t>> NegatedClasses(const Explanation& explanation);
  /// The functions that compute its results, as actions of a rule; none if there are none.
  ProductionPtr Functions(const Explanation& explanation, const IdentityPlan& plan);

 private:
  /// Converts a function of a firing's rule so that it refers to the conditions of the justification.
  ValueDraft MoveFunction(const RhsValue& function, InstantiationId firing, const IdentityPlan& plan);
  /// The class of an identity; kLiteral if it was literalized or if no condition or result has it.
  std::uint16_t ClassOf(IdentityGraph::Node node) const;
  /// Like ClassOf, but an identity without a class gets the class `next`, and `second` is true.
  std::pair<std::uint16_t, bool> Classify(IdentityGraph::Node node, std::uint16_t next);

  Uses uses_;
  FiringReader& reader_;
  IdentityAnalysis& analysis_;
  CarriedTests& carried_;
  Arena arena_;
  std::unordered_map<IdentityGraph::Node, std::uint16_t> class_of_;  ///< By representative of the identity set.
  std::vector<CarriedTest> constraints_;
};

}  // namespace soarbox::kernel
