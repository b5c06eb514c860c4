// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/memory/slot_index.h"

#include <utility>

namespace soarbox::kernel {

std::uint32_t SlotIndex::Hash(std::uint32_t id, std::uint32_t attribute) {
  const std::uint64_t mixed = (static_cast<std::uint64_t>(id) << 32 | attribute) * 0x9E3779B97F4A7C15ull;
  return static_cast<std::uint32_t>(mixed >> 32);
}

SlotId SlotIndex::Find(Symbol id, Symbol attribute) const {
  if (count_ == 0) return SlotId::kNone;
  const std::uint32_t mask = static_cast<std::uint32_t>(entries_.size()) - 1;
  for (std::uint32_t place = Hash(id.bits(), attribute.bits()) & mask;; place = (place + 1) & mask) {
    const Entry& entry = entries_[place];
    if (entry.slot == SlotId::kNone) return SlotId::kNone;
    if (entry.id == id.bits() && entry.attribute == attribute.bits()) return entry.slot;
  }
}

void SlotIndex::Insert(Symbol id, Symbol attribute, SlotId slot) {
  if ((count_ + 1) * 4 > entries_.size() * 3) Grow();
  const std::uint32_t mask = static_cast<std::uint32_t>(entries_.size()) - 1;
  std::uint32_t place = Hash(id.bits(), attribute.bits()) & mask;
  while (entries_[place].slot != SlotId::kNone) place = (place + 1) & mask;
  entries_[place] = {id.bits(), attribute.bits(), slot};
  ++count_;
}

void SlotIndex::Erase(Symbol id, Symbol attribute) {
  const std::uint32_t mask = static_cast<std::uint32_t>(entries_.size()) - 1;
  std::uint32_t hole = Hash(id.bits(), attribute.bits()) & mask;
  while (entries_[hole].id != id.bits() || entries_[hole].attribute != attribute.bits()) hole = (hole + 1) & mask;
  // Closes the gap: moves back every later entry of the run whose home is not after the gap.
  for (std::uint32_t place = (hole + 1) & mask; entries_[place].slot != SlotId::kNone; place = (place + 1) & mask) {
    const std::uint32_t home = Hash(entries_[place].id, entries_[place].attribute) & mask;
    if (((place - home) & mask) >= ((place - hole) & mask)) {
      entries_[hole] = entries_[place];
      hole = place;
    }
  }
  entries_[hole] = Entry{};
  --count_;
}

void SlotIndex::Clear() {
  for (Entry& entry : entries_) entry = Entry{};
  count_ = 0;
}

void SlotIndex::Grow() {
  std::vector<Entry> old(entries_.empty() ? 32 : entries_.size() * 2);
  std::swap(old, entries_);
  const std::uint32_t mask = static_cast<std::uint32_t>(entries_.size()) - 1;
  for (const Entry& entry : old) {
    if (entry.slot == SlotId::kNone) continue;
    std::uint32_t place = Hash(entry.id, entry.attribute) & mask;
    while (entries_[place].slot != SlotId::kNone) place = (place + 1) & mask;
    entries_[place] = entry;
  }
}

}  // namespace soarbox::kernel
