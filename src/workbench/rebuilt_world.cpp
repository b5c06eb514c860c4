// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/rebuilt_world.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace soarbox::workbench {

void RebuiltWorld::Aim(std::uint64_t tick) {
  tick_ = tick;
  if (way_ == Way::kToOneTick) {
    trouble_.clear();
    branch_.reset();
  } else if (branch_ != nullptr && (branch_->tick() > tick || std::exchange(is_spoilt_, false))) {
    // A branch cannot go back to an earlier tick, and the user may have changed this one.
    branch_.reset();
  }
}

void RebuiltWorld::GiveUp() {
  tick_.reset();
  branch_.reset();
  trouble_.clear();
}

void RebuiltWorld::Advance(double most_s) {
  if (!tick_ || !IsPossible()) return;
  if (branch_ == nullptr) {
    Result<std::unique_ptr<record::Branch>> begun = begin_(*tick_);
    if (!begun) {
      trouble_ = begun.error().message;
      return;
    }
    branch_ = std::move(*begun);
  }
  const auto begin = std::chrono::steady_clock::now();
  constexpr std::uint64_t kAtOnce = 5;
  while (branch_->tick() < *tick_ &&
         std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < most_s) {
    const std::uint64_t ticks = std::min(kAtOnce, *tick_ - branch_->tick());
    if (const Result<void> advanced = branch_->Advance(ticks); !advanced) {
      trouble_ = advanced.error().message;
      branch_.reset();
      return;
    }
  }
}

sim::Simulation* RebuiltWorld::world() {
  const bool is_there =
      branch_ != nullptr && tick_ && branch_->tick() == *tick_ && (way_ == Way::kOnward || branch_->IsThere());
  return is_there ? &branch_->simulation() : nullptr;
}

std::string RebuiltWorld::Note() const {
  if (!IsPossible()) return "The mind at this moment cannot be rebuilt: " + trouble_;
  const std::uint64_t at = branch_ != nullptr ? branch_->tick() : 0,
                      goal = std::max<std::uint64_t>(1, tick_.value_or(0));
  return "Rebuilding the minds of this moment: " + std::to_string(100 * at / goal) + " %";
}

}  // namespace soarbox::workbench
