// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

class Agent;
class Descriptions;
class Firing;
class GoalChanges;
class GoalStack;
class InstantiationTable;
class Observers;
class WorkingMemory;

/// Goal dependency sets (Soar manual 2.7.1). The set of a substate contains the elements of higher states on which the
/// substate's o-supported elements depend. It also contains elements of the substate itself on which they depend and
/// that no rule created. When a member is removed, the substate is removed.
///
/// An element belongs to at most one set: that of the highest goal that depends on it.
class GoalDependencySets {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    Agent& agent;
    WorkingMemory& memory;
    GoalStack& goals;
    InstantiationTable& instantiations;
    const Firing& firing;
    GoalChanges& goal_changes;
    const Descriptions& descriptions;
    const Observers& observers;
  };
  explicit GoalDependencySets(const Uses& uses) : uses_(uses) {}

  /// An element was created for a preference. If the preference is o-supported and belongs to a substate, the elements
  /// on which it depends are added to the substate's set.
  void NoteNewFact(WmeId wme);
  /// A member of a set is about to be removed: removes its goal and all goals below first.
  [[gnu::noinline]] void MemberLeaves(WmeId wme);
  /// The element is removed without effect on the goal.
  [[gnu::noinline]] void Forget(WmeId wme);
  /// The goal is being removed: its set is cleared.
  void GoalRemoved(GoalLevel level);

 private:
  [[gnu::noinline]] void Collect(InstantiationId instantiation);
  void AddMember(WmeId wme, GoalLevel level);
  void Queue(InstantiationId instantiation);

  Uses uses_;
  std::vector<InstantiationId> queue_, exploring_;
};

}  // namespace soarbox::kernel
