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

/// Goal dependency sets (Soar manual 2.7.1): for each substate the elements of higher states that its first o-supported
/// fact rests on. When one of them leaves, the substate goes.
///
/// An element belongs to at most one set: that of the highest goal that needs it.
class GoalDependencySets {
 public:
  /// What it uses of the agent.
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

  /// An element was made for a preference: if an o-supported preference of a substate is behind it, what that rests on
  /// enters the substate's set.
  void NoteNewFact(WmeId wme);
  /// A member of a set is about to leave: its goal and all below go first.
  [[gnu::noinline]] void MemberLeaves(WmeId wme);
  /// The element leaves without harm to the goal.
  [[gnu::noinline]] void Forget(WmeId wme);
  /// The goal is going: its members are free.
  void GoalRemoved(GoalLevel level);

 private:
  [[gnu::noinline]] void Collect(InstantiationId instantiation);
  void AddMember(WmeId wme, GoalLevel level);
  void Queue(InstantiationId instantiation);

  Uses uses_;
  std::vector<InstantiationId> queue_, exploring_;
};

}  // namespace soarbox::kernel
