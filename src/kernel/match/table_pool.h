// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace soarbox::kernel {

/// Tables of 2^n words from one array, with free lists by size. Offsets stay valid while the pool grows.
class TablePool {
 public:
  /// A table of 2^bits words, all kNil.
  std::uint32_t Allocate(std::uint32_t bits) {
    const std::size_t size = std::size_t{1} << bits;
    std::uint32_t table = free_[bits];
    if (table != kNone) {
      free_[bits] = words_[table];
    } else {
      table = static_cast<std::uint32_t>(words_.size());
      words_.resize(words_.size() + size);
    }
    std::fill_n(words_.begin() + table, size, kNone);
    return table;
  }
  void Free(std::uint32_t table, std::uint32_t bits) {
    words_[table] = free_[bits];
    free_[bits] = table;
  }
  /// The highest `bits` bits (1 to 31) of a product.
  static std::uint32_t Hash(std::uint32_t key, std::uint32_t bits) {
    return (key * 0x9E3779B1u) >> ((0u - bits) & 31u);
  }
  std::uint32_t& operator[](std::uint32_t word) { return words_[word]; }
  std::uint32_t operator[](std::uint32_t word) const { return words_[word]; }
  std::size_t MemoryBytes() const { return words_.capacity() * sizeof(std::uint32_t); }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::vector<std::uint32_t> words_;
  std::uint32_t free_[32] = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone,
                             kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone,
                             kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
};

}  // namespace soarbox::kernel
