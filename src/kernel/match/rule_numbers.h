// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/match/match_set.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// The numbers of an agent's rules: which are free, and which belong to excised rules whose last match has not gone.
///
/// Invariants: a number is free, in use or excised; the rule of an excised number is kept until the number is free.
class RuleNumbers {
 public:
  /// A number for a new rule: the one that was freed last, else the first that no rule has had (`limit`).
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
  /// The number that was taken last is not used.
  void GiveBack(std::uint32_t number, std::uint32_t limit) {
    if (number < limit) {
      free_.push_back(number);
    }
  }
  /// A rule is excised. Its matches may stay for a while.
  void Retire(std::uint32_t number, ProductionPtr rule) {
    if (number >= retired_.size()) {
      retired_.resize(number + 1u);
    }
    retired_[number] = std::move(rule);
    excised_.push_back(number);
  }
  /// The excised rule that had a number last, or null.
  const ProductionPtr& Retired(std::uint32_t number) const {
    static const ProductionPtr kNone;
    return number < retired_.size() ? retired_[number] : kNone;
  }

 private:
  std::vector<std::uint32_t> free_;     ///< Last freed last.
  std::vector<std::uint32_t> excised_;  ///< Rules excised whose last match may not be released yet.
  std::vector<ProductionPtr> retired_;  ///< By number.
};

}  // namespace soarbox::kernel
