// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/match/match_set.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// The numbers of an agent's rules: which are free, and which belong to excised rules with remaining matches.
///
/// Invariants: a number is free, in use or excised; the rule of an excised number is kept until the number is free.
class RuleNumbers {
 public:
  /// A number for a new rule: the one freed last, or the first that no rule has had (`limit`).
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
  /// Returns the number taken last, unused.
  void GiveBack(std::uint32_t number, std::uint32_t limit) {
    if (number < limit) {
      free_.push_back(number);
    }
  }
  /// A rule is excised. Its matches may remain for a while.
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
  std::vector<std::uint32_t> free_;     ///< The one freed last is last.
  std::vector<std::uint32_t> excised_;  ///< Excised rules that may still have unreleased matches.
  std::vector<ProductionPtr> retired_;  ///< By number.
};

}  // namespace soarbox::kernel
