// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace soarbox::server {

/// A hash map from time tags of clients to values, with open addressing. Allocates only when it grows. Tag 0 is not a
/// valid key. The order of iteration is unspecified: sort what you list.
template <typename Value>
class TagMap {
 public:
  const Value* Find(std::int64_t tag) const {
    const std::size_t at = Locate(tag);
    return at == kNowhere ? nullptr : &slots_[at].second;
  }
  Value* Find(std::int64_t tag) {
    const std::size_t at = Locate(tag);
    return at == kNowhere ? nullptr : &slots_[at].second;
  }
  void Set(std::int64_t tag, const Value& value) {
    if (Value* found = Find(tag)) {
      *found = value;
      return;
    }
    Add(tag, value);
  }
  /// Adds a value; the tag must not be present.
  void Add(std::int64_t tag, const Value& value) {
    if ((size_ + 1) * 2 > slots_.size()) Grow();
    Insert(tag, value);
  }
  /// Removes the tag and returns its value.
  std::optional<Value> Take(std::int64_t tag) {
    const std::size_t hole = Locate(tag);
    if (hole == kNowhere) return std::nullopt;
    const Value value = slots_[hole].second;
    Close(hole);
    return value;
  }
  template <typename Drop>
  void RemoveIf(Drop drop) {
    for (std::size_t i = 0; i < slots_.size();) {
      if (slots_[i].first != 0 && drop(slots_[i].first, slots_[i].second)) {
        Close(i);  // Another entry may have come here.
      } else {
        ++i;
      }
    }
  }
  template <typename Visit>
  void ForEach(Visit visit) const {
    for (const Slot& slot : slots_) {
      if (slot.first != 0) visit(slot.first, slot.second);
    }
  }
  void Clear() {
    slots_.assign(slots_.size(), Slot{});
    size_ = 0;
  }
  std::size_t size() const { return size_; }

 private:
  struct Slot {
    std::int64_t first = 0;
    Value second{};
  };

  static constexpr std::size_t kNowhere = ~std::size_t{0};

  std::size_t Locate(std::int64_t tag) const {
    if (slots_.empty() || tag == 0) return kNowhere;
    for (std::size_t i = Home(tag);; i = Next(i)) {
      if (slots_[i].first == tag) return i;
      if (slots_[i].first == 0) return kNowhere;
    }
  }
  std::size_t Home(std::int64_t tag) const {
    return (static_cast<std::uint64_t>(tag) * 0x9E3779B97F4A7C15ull >> 32) & (slots_.size() - 1);
  }
  std::size_t Next(std::size_t i) const { return (i + 1) & (slots_.size() - 1); }
  /// Removes an entry. Moves later entries of the run back, so that no search ends at a hole before its entry.
  void Close(std::size_t hole) {
    --size_;
    for (std::size_t i = Next(hole); slots_[i].first != 0; i = Next(i)) {
      const std::size_t home = Home(slots_[i].first);
      const bool stays = hole <= i ? (hole < home && home <= i) : (hole < home || home <= i);
      if (stays) continue;
      slots_[hole] = slots_[i];
      hole = i;
    }
    slots_[hole] = Slot{};
  }
  void Insert(std::int64_t tag, const Value& value) {
    std::size_t i = Home(tag);
    while (slots_[i].first != 0) i = Next(i);
    slots_[i] = Slot{tag, value};
    ++size_;
  }
  void Grow() {
    std::vector<Slot> old = std::move(slots_);
    slots_.assign(old.empty() ? 16 : old.size() * 2, Slot{});
    size_ = 0;
    for (const Slot& slot : old) {
      if (slot.first != 0) Insert(slot.first, slot.second);
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace soarbox::server
