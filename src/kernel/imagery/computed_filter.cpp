// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/computed_filter.h"

#include <algorithm>

namespace soarbox::kernel::imagery {

bool ComputedFilter::Compute() {
  TrackedList<Combination>& combinations = inputs().combinations();
  const auto evaluate = [&](Combination& combination) {
    Content content;
    switch (Evaluate(combination, content)) {
      case Verdict::kFail:
        return false;
      case Verdict::kNothing:
        Drop(combination);
        return true;
      case Verdict::kValue:
        break;
    }
    Give(&combination, std::move(content));
    return true;
  };
  for (Combination& fresh : combinations.fresh()) {
    if (!evaluate(fresh)) return false;
  }
  for (Combination* const changed : combinations.changed()) {
    if (changed != nullptr && !evaluate(*changed)) return false;
  }
  for (Combination& removed : combinations.removed()) Drop(removed);
  return true;
}

bool RankFilter::Compute() {
  TrackedList<Combination>& combinations = inputs().combinations();
  if (!combinations.HasChanges()) return true;
  const auto rank = [&](Combination& combination) {
    const std::optional<double> rank = Rank(combination);
    combination.rank = rank.value_or(0);
    return rank.has_value();
  };
  for (Combination& fresh : combinations.fresh()) {
    if (!rank(fresh)) return false;
  }
  for (Combination* const changed : combinations.changed()) {
    if (changed != nullptr && !rank(*changed)) return false;
  }
  if (!MayChange(combinations)) return true;
  Combination* best = nullptr;
  for (Combination& combination : combinations) {
    if (best == nullptr || (highest_ ? combination.rank > best->rank : combination.rank < best->rank)) {
      best = &combination;
    }
  }
  if (best_ != nullptr && best_ != best) Drop(*best_);
  best_ = best;
  if (best_ != nullptr) Give(best_, best_->rank);
  return true;
}

/// Whether a different combination may be the best one now. This is so if the best one changed or was removed, or if a
/// new or changed one is at least as good.
bool RankFilter::MayChange(TrackedList<Combination>& combinations) const {
  if (best_ == nullptr || best_->changed != 0) return true;
  const auto rivals = [this](const Combination& combination) {
    return highest_ ? combination.rank >= best_->rank : combination.rank <= best_->rank;
  };
  for (const Combination& gone : combinations.removed()) {
    if (&gone == best_) return true;
  }
  for (Combination& fresh : combinations.fresh()) {
    if (rivals(fresh)) return true;
  }
  return std::any_of(combinations.changed().begin(), combinations.changed().end(),
                     [&](const Combination* changed) { return changed != nullptr && rivals(*changed); });
}

void RankFilter::ClearOutput() {
  best_ = nullptr;
  Filter::ClearOutput();
}

}  // namespace soarbox::kernel::imagery
