// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/plain_vector.h"

namespace soarbox::kernel {

/// The number of an episode, from 1. 0 means none.
using EpisodeNumber = std::uint32_t;

/// The episodes from `start` to `end`, both included.
struct EpisodeInterval {
  EpisodeNumber start = 0, end = 0;

  friend bool operator==(const EpisodeInterval&, const EpisodeInterval&) = default;
};

/// Many growing lists of intervals in one array. The capacity of a list is a power of two. When a list outgrows its
/// block, the block is reused for another list of that size.
class EpisodeIntervals {
 public:
  struct List {
    std::uint32_t first = 0, count = 0;
  };

  std::span<const EpisodeInterval> Of(List list) const { return {all_.data() + list.first, list.count}; }

  void Append(List& list, EpisodeInterval interval) {
    if (std::has_single_bit(list.count) || list.count == 0) Grow(list);
    all_[list.first + list.count++] = interval;
  }

  void Clear() {
    all_.clear();
    for (std::vector<std::uint32_t>& list : free_) list.clear();
  }

  std::size_t MemoryBytes() const { return all_.capacity() * sizeof(EpisodeInterval); }

 private:
  /// Moves a full list to a block of twice the size.
  void Grow(List& list) {
    const std::size_t old_class = static_cast<std::size_t>(std::bit_width(list.count));  // 0: no block yet.
    const std::uint32_t room = list.count == 0 ? 1 : list.count * 2;
    std::uint32_t first = 0;
    if (std::vector<std::uint32_t>& free = free_[old_class]; !free.empty()) {
      first = free.back();
      free.pop_back();
    } else {
      first = static_cast<std::uint32_t>(all_.size());
      all_.resize(all_.size() + room);
    }
    std::copy_n(all_.data() + list.first, list.count, all_.data() + first);
    if (list.count != 0) free_[old_class - 1].push_back(list.first);
    list.first = first;
  }

  PlainVector<EpisodeInterval> all_;
  std::array<std::vector<std::uint32_t>, 34> free_;  ///< By the binary logarithm of the capacity.
};

}  // namespace soarbox::kernel
