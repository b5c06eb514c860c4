// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soarbox::kernel {

/// A map from non-zero 64-bit keys to 32-bit numbers, with open addressing; at most three quarters full.
class FlatMap {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  std::uint32_t Find(std::uint64_t key) const {
    if (entries_.empty()) return kNone;
    for (std::size_t at = Home(key);; at = (at + 1) & (entries_.size() - 1)) {
      if (entries_[at].key == key) return entries_[at].value;
      if (entries_[at].key == 0) return kNone;
    }
  }
  /// Returns the number of a key; a new key gets the number `value`.
  std::uint32_t FindOrAdd(std::uint64_t key, std::uint32_t value) {
    if ((count_ + 1) * 4 > entries_.size() * 3) Grow();
    for (std::size_t at = Home(key);; at = (at + 1) & (entries_.size() - 1)) {
      if (entries_[at].key == key) return entries_[at].value;
      if (entries_[at].key != 0) continue;
      entries_[at] = {key, value};
      ++count_;
      return value;
    }
  }
  std::size_t size() const { return count_; }
  std::size_t MemoryBytes() const { return entries_.capacity() * sizeof(Entry); }
  void Clear() {
    entries_.clear();
    count_ = 0;
  }

 private:
  struct Entry {
    std::uint64_t key = 0;
    std::uint32_t value = 0;
  };
  std::size_t Home(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> 20) & (entries_.size() - 1);
  }
  void Grow() {
    std::vector<Entry> old(entries_.empty() ? 8 : entries_.size() * 2);
    old.swap(entries_);
    for (const Entry& entry : old) {
      if (entry.key == 0) continue;
      std::size_t at = Home(entry.key);
      while (entries_[at].key != 0) at = (at + 1) & (entries_.size() - 1);
      entries_[at] = entry;
    }
  }

  std::vector<Entry> entries_;
  std::size_t count_ = 0;
};

}  // namespace soarbox::kernel
