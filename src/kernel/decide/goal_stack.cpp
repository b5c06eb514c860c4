// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/goal_stack.h"

namespace soarbox::kernel {

Goal& GoalStack::Push() {
  if (depth_ == goals_.size()) goals_.emplace_back();
  Goal& goal = goals_[depth_++];
  // Keeps the allocated memory of the record's lists.
  std::vector<WmeId> items = std::move(goal.items);
  std::vector<WmeId> gds = std::move(goal.gds);
  goal = Goal{};
  items.clear();
  gds.clear();
  goal.items = std::move(items);
  goal.gds = std::move(gds);
  goal.level = static_cast<GoalLevel>(depth_);
  return goal;
}

}  // namespace soarbox::kernel
