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

/// What a justification keeps of the reasoning that it stands for, so that what is learned above it is as general as
/// if it had been learned from that reasoning. Plan comes first; the others use what it found.
class JustificationPlanner {
 public:
  /// What it uses of the agent.
  struct Uses {
    const WorkingMemory& memory;
    const InstantiationTable& instantiations;
    LearnStatistics& statistics;
  };
  JustificationPlanner(const Uses& uses, FiringReader& reader, IdentityAnalysis& analysis, CarriedTests& carried)
      : uses_(uses), reader_(reader), analysis_(analysis), carried_(carried) {}

  /// Its identity sets as classes: the class of each field of the conditions, and of the actions.
  IdentityPlan Plan(const Explanation& explanation);
  /// What its conditions test beside equality. `counts`: its tests are new to the statistics.
  std::vector<IdentityPlan::KeptTest> Tests(const Explanation& explanation, bool counts);
  /// For each negated condition, the classes of what its tests name, in the order of ForEachTest.
  std::vector<std::vector<std::uint16_t>> NegatedClasses(const Explanation& explanation);
  /// What its results are computed by, as actions of a rule; none if none is.
  ProductionPtr Functions(const Explanation& explanation, const IdentityPlan& plan);

 private:
  /// A function of a firing's rule, over the conditions of the justification.
  ValueDraft MoveFunction(const RhsValue& function, InstantiationId firing, const IdentityPlan& plan);
  /// The class of an identity; kLiteral if it stands for a constant or if no condition or result has it.
  std::uint16_t ClassOf(IdentityGraph::Node node) const;
  /// The same, but it gets the class `next` if it has none (second: true).
  std::pair<std::uint16_t, bool> Classify(IdentityGraph::Node node, std::uint16_t next);

  Uses uses_;
  FiringReader& reader_;
  IdentityAnalysis& analysis_;
  CarriedTests& carried_;
  Arena arena_;
  std::unordered_map<IdentityGraph::Node, std::uint16_t> class_of_;  ///< By root.
  std::vector<CarriedTest> constraints_;
};

}  // namespace soarbox::kernel
