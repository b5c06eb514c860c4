// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/memory_link.h"
#include "kernel/memory/preference.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

/// A state on the goal stack.
struct Goal {
  Symbol id;
  GoalLevel level = 0;
  SlotId operator_slot = SlotId::kNone;
  Symbol reward_link;
  MemoryLink epmem, smem;
  ImpasseType impasse = ImpasseType::kNone;  ///< The impasse that created it; kNone for the top state.
  bool impasse_on_operator = false;          ///< ^attribute is operator; if false, it is state.
  std::uint64_t created_in_decision = 0;
  PreferenceId preferences = PreferenceId::kNone;  ///< Of all instantiations that matched it, newest first.
  PreferenceId oldest_preference = PreferenceId::kNone;
  std::vector<WmeId> items;  ///< Its ^item, ^item-count, ^non-numeric and ^non-numeric-count elements.
  bool has_gds = false;
  std::vector<WmeId> gds;                     ///< Its goal dependency set (goal_dependency_set.h).
  FiringType saved_firing = FiringType::kIe;  ///< Restored when elaboration reaches this goal again.
  bool has_saved_firing = false;
  bool has_identities = false;  ///< It was created while learning was on.
  bool learned_below = false;   ///< One of its substates had results.
};

/// The states of an agent, top state first: goals()[n] has level n + 1. Goal records are reused by later goals of the
/// same level, so that creating and removing substates does not allocate.
class GoalStack {
 public:
  std::size_t depth() const { return depth_; }
  bool empty() const { return depth_ == 0; }
  const Goal& top() const { return goals_[0]; }
  const Goal& bottom() const { return goals_[depth_ - 1]; }
  /// `level` is from 1 to depth().
  const Goal& at(GoalLevel level) const { return goals_[level - 1u]; }
  Goal& at(GoalLevel level) { return goals_[level - 1u]; }
  Goal& Push();
  void Pop() { --depth_; }
  void Clear() { depth_ = 0; }

 private:
  std::vector<Goal> goals_;
  std::size_t depth_ = 0;
};

}  // namespace soarbox::kernel
