// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/preference_semantics.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

struct AgentCore;

/// Creates and removes states with the elements of the architecture, in an order that time tags show: type, superstate,
/// reward-link, epmem, smem, (top state: io,) attribute, impasse, choices, quiescence, items.
class GoalChanges {
 public:
  explicit GoalChanges(AgentCore& core) : core_(core) {}

  void MakeTopState();
  /// Creates ^io of the top state, with the input link and the output link.
  void MakeIoLinks();
  /// Creates a substate of the bottom goal. `candidates` are the items of a tie, conflict or constraint failure.
  void MakeSubstate(ImpasseType impasse, bool on_operator, std::span<const Candidate> candidates);
  /// Updates the items of the substate below `level`. Unchanged elements keep their time tags.
  void UpdateItems(GoalLevel level, std::span<const Candidate> candidates);
  /// For an element that is an item of an impasse: the element of the proposal in the superstate. kNone for others.
  WmeId ProposalOfItem(WmeId item) const;
  /// Removes the goal of this level and all goals below, the lowest first.
  [[gnu::noinline]] void RemoveFrom(GoalLevel level, GoalRemoval reason);
  /// init-soar: removes all states, the lowest first, so that their elements leave the match in Soar's order. This
  /// order determines which rule fires first afterwards. Observers are not informed. Modules are: rewards of substates
  /// still count.
  void TakeAllApart();
  /// Removes everything that an unreachable identifier owns.
  void CollectGarbage(Symbol id);

  /// Sets the value of ^epmem.present-id for states created from now on: the number of the next episode.
  void SetPresentId(std::int64_t number) { present_id_ = number; }

  Symbol input_link() const { return input_link_; }
  Symbol output_link() const { return output_link_; }

 private:
  Goal& PushGoal();
  void AddMemoryLinks(Goal& goal);
  MemoryLink AddMemoryLink(Symbol state, Symbol attribute, char letter);
  Symbol AddModule(Symbol owner, Symbol attribute, char letter);
  WmeId AddSlotWme(Symbol id, Symbol attribute, Symbol value);
  WmeId AddArchitecture(Symbol id, Symbol attribute, Symbol value);
  void RemoveBottom();
  void TakeBottomApart();
  template <typename Visit>
  void ForEachItemInRemovalOrder(const Goal& goal, Visit visit) const;

  AgentCore& core_;
  Symbol input_link_, output_link_;
  std::int64_t present_id_ = 1;
  std::vector<WmeId> kept_items_;
};

}  // namespace soarbox::kernel
