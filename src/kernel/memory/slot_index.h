// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/symbol.h"
#include "kernel/memory/preference.h"

namespace soarbox::kernel {

/// Finds the slot of an identifier and attribute: one open-addressing table per agent. Erasing shifts later entries
/// back, so there are no tombstones. Grows by doubling; never shrinks.
class SlotIndex {
 public:
  SlotId Find(Symbol id, Symbol attribute) const;
  /// The key must not be present.
  void Insert(Symbol id, Symbol attribute, SlotId slot);
  /// The key must be present.
  void Erase(Symbol id, Symbol attribute);
  void Clear();
  std::size_t MemoryBytes() const { return entries_.capacity() * sizeof(Entry); }

 private:
  struct Entry {
    std::uint32_t id = 0, attribute = 0;
    SlotId slot = SlotId::kNone;  ///< kNone: the entry is empty.
  };
  static std::uint32_t Hash(std::uint32_t id, std::uint32_t attribute);
  [[gnu::noinline]] void Grow();

  std::vector<Entry> entries_;
  std::uint32_t count_ = 0;
};

}  // namespace soarbox::kernel
