// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// Expected numbers of values of attributes (`production optimize-attribute`). The reorderer multiplies the cost of
/// conditions with such an attribute by this number. Applies to rules loaded later.
///
/// Its symbols must be pinned, because nothing marks them in a sweep.
class ExpectedValues {
 public:
  /// `count` must be at least 1.
  void Set(Symbol attribute, std::int64_t count) {
    const auto known = std::ranges::find(counts_, attribute, &Count::first);
    if (known != counts_.end()) {
      known->second = count;
    } else {
      counts_.emplace_back(attribute, count);
    }
  }
  /// Returns 1 for attributes without an entry.
  std::int64_t Of(Symbol attribute) const {
    const auto known = std::ranges::find(counts_, attribute, &Count::first);
    return known != counts_.end() ? known->second : 1;
  }

  using Count = std::pair<Symbol, std::int64_t>;
  const std::vector<Count>& all() const { return counts_; }

 private:
  std::vector<Count> counts_;
};

}  // namespace soarbox::kernel
