// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/match/match_set.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// The numbers of an agent's rules: free ones, and those of excised rules that still have matches.
///
/// Invariants: a number is free, in use or excised; the rule of an excised number is kept until the number is free.
class RuleNumbers {
 public:
  /// Assigns a number to a new rule: the one freed last, or the first unused one (`limit`).
  std::uint32_t Take(const MatchSet& matches, std::uint32_t limit) {
    std::erase_if(excised_, [&](std::uint32_t number) {
      if (matches.LiveCount(number) != 0) {
        return false;
      }
      retired_[number].reset();
      free_.push_back(number);
      return true;
    });
    if (free_.empty()) {
      return limit;
    }
    const std::uint32_t number = free_.back();
    free_.pop_back();
    return number;
  }
  /// Frees the number assigned last, which was not used.
  void GiveBack(std::uint32_t number, std::uint32_t limit) {
    if (number < limit) {
      free_.push_back(number);
    }
  }
  /// A rule was excised. It may have matches for a while.
  void Retire(std::uint32_t number, ProductionPtr rule) {
    if (number >= retired_.size()) {
      retired_.resize(number + 1u);
    }
    retired_[number] = std::move(rule);
    excised_.push_back(number);
  }
  /// The last excised rule with this number, or null.
  const ProductionPtr& Retired(std::uint32_t number) const {
    static const ProductionPtr kNone;
    return number < retired_.size() ? retired_[number] : kNone;
  }

 private:
  std::vector<std::uint32_t> free_;     ///< The one freed last is at the end.
  std::vector<std::uint32_t> excised_;  ///< Excised rules that may still have unreleased matches.
  std::vector<ProductionPtr> retired_;  ///< By number.
};

}  // namespace soarbox::kernel
