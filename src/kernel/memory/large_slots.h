// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

struct Slot;

/// For slots with very many preferences: how many o-supported acceptable ones there are for each value. (Walking all of
/// them for each new one would take time that grows with the square of their number.)
class LargeSlots {
 public:
  using Counts = std::unordered_map<std::uint32_t, std::uint32_t>;  ///< By Symbol::bits().

  void Add(const Slot* slot, Counts counts) { slots_.emplace(slot, std::move(counts)); }
  void Remove(const Slot* slot) { slots_.erase(slot); }
  void CountUp(const Slot* slot, Symbol value) { ++slots_.at(slot)[value.bits()]; }
  void CountDown(const Slot* slot, Symbol value) {
    Counts& counts = slots_.at(slot);
    if (const auto at = counts.find(value.bits()); at != counts.end() && --at->second == 0) counts.erase(at);
  }
  bool Has(const Slot* slot, Symbol value) const { return slots_.at(slot).contains(value.bits()); }
  const Counts& CountsOf(const Slot* slot) const { return slots_.at(slot); }
  std::size_t size() const { return slots_.size(); }
  void Clear() { slots_.clear(); }
  std::size_t MemoryBytes() const {
    std::size_t entries = 0;
    for (const auto& [slot, counts] : slots_) entries += counts.size();
    return entries * (sizeof(Counts::value_type) + 2 * sizeof(void*));
  }

 private:
  std::unordered_map<const Slot*, Counts> slots_;
};

}  // namespace soarbox::kernel
