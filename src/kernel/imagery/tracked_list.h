// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

namespace soarbox::kernel::imagery {

/// The data that a TrackedList stores in each of its entries; entries derive from it.
template <typename Entry>
struct Tracked {
  Entry *previous = nullptr, *next = nullptr;  ///< In the list, or in the list of removed entries.
  std::uint32_t slot = 0;                      ///< The entry's number; reused after the entry is forgotten.
  std::uint32_t changed = 0;                   ///< 1 + its index among the changed entries; 0: it did not change.
  bool fresh = true;                           ///< It was added since the changes were last cleared.
};

/// A list in order of insertion that records additions, changes and removals until the changes are cleared. Entries do
/// not move; the memory of removed ones is reused.
template <typename Entry>
class TrackedList {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Entry;
    using difference_type = std::ptrdiff_t;
    using pointer = Entry*;
    using reference = Entry&;

    Iterator() = default;
    explicit Iterator(Entry* entry) : entry_(entry) {}
    Entry& operator*() const { return *entry_; }
    Entry* operator->() const { return entry_; }
    Iterator& operator++() {
      entry_ = entry_->next;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    Entry* entry_ = nullptr;
  };
  struct Range {
    Entry* first = nullptr;
    Iterator begin() const { return Iterator(first); }
    Iterator end() const { return {}; }
  };

  TrackedList() = default;
  TrackedList(const TrackedList&) = delete;
  TrackedList& operator=(const TrackedList&) = delete;

  std::size_t size() const { return size_; }
  Iterator begin() const { return Iterator(first_); }
  Iterator end() const { return {}; }
  /// Added entries are at the end of the list.
  Range fresh() const { return {first_fresh_}; }
  /// Contains null for changed entries that were removed.
  const std::vector<Entry*>& changed() const { return changed_; }
  /// Removed entries, which can be read until the changes are cleared. Includes added entries that were removed again.
  Range removed() const { return {removed_}; }
  bool HasChanges() const { return first_fresh_ != nullptr || !changed_.empty() || removed_ != nullptr; }
  /// All slots are less than this number.
  std::uint32_t slots() const { return used_; }
  Entry& At(std::uint32_t slot) {
    return slot < kFirst ? chunks_[0][slot] : chunks_[1 + (slot - kFirst) / kMore][(slot - kFirst) % kMore];
  }

  /// Appends an entry with its default contents.
  Entry& Add() {
    std::uint32_t slot = used_;
    if (!free_.empty()) {
      slot = free_.back();
      free_.pop_back();
    } else {
      if (used_ == 0) chunks_.push_back(std::make_unique<Entry[]>(kFirst));
      if (used_ >= kFirst && (used_ - kFirst) % kMore == 0) chunks_.push_back(std::make_unique<Entry[]>(kMore));
      ++used_;
    }
    Entry& added = At(slot);
    added = Entry();
    added.slot = slot;
    added.previous = last_;
    (last_ == nullptr ? first_ : last_->next) = &added;
    last_ = &added;
    if (first_fresh_ == nullptr) first_fresh_ = &added;
    ++size_;
    return added;
  }
  void Change(Entry& entry) {
    if (entry.fresh || entry.changed != 0) return;
    changed_.push_back(&entry);
    entry.changed = static_cast<std::uint32_t>(changed_.size());
  }
  void Remove(Entry& entry) {
    if (entry.changed != 0) changed_[entry.changed - 1] = nullptr;
    if (first_fresh_ == &entry) first_fresh_ = entry.next;
    (entry.previous == nullptr ? first_ : entry.previous->next) = entry.next;
    (entry.next == nullptr ? last_ : entry.next->previous) = entry.previous;
    entry.previous = last_removed_;
    entry.next = nullptr;
    (last_removed_ == nullptr ? removed_ : last_removed_->next) = &entry;
    last_removed_ = &entry;
    --size_;
  }
  void ClearChanges() {
    for (Entry* at = first_fresh_; at != nullptr; at = at->next) at->fresh = false;
    first_fresh_ = nullptr;
    for (Entry* const entry : changed_) {
      if (entry != nullptr) entry->changed = 0;
    }
    changed_.clear();
    ForgetRemoved();
  }
  /// Marks every entry as added.
  void Restart() {
    ClearChanges();
    first_fresh_ = first_;
    for (Entry& entry : *this) entry.fresh = true;
  }
  void Clear() {
    ForgetRemoved();
    for (Entry* at = first_; at != nullptr; at = at->next) free_.push_back(at->slot);
    changed_.clear();
    first_ = last_ = first_fresh_ = nullptr;
    size_ = 0;
  }
  std::size_t MemoryBytes() const {
    const std::size_t room = chunks_.empty() ? 0 : kFirst + (chunks_.size() - 1) * kMore;
    return room * sizeof(Entry) + changed_.capacity() * sizeof(void*) + free_.capacity() * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::uint32_t kFirst = 4, kMore = 64;

  void ForgetRemoved() {
    for (Entry* at = removed_; at != nullptr; at = at->next) free_.push_back(at->slot);
    removed_ = last_removed_ = nullptr;
  }

  std::vector<std::unique_ptr<Entry[]>> chunks_;  ///< The first chunk is small, because most lists have few entries.
  std::vector<std::uint32_t> free_;
  std::uint32_t used_ = 0;
  std::size_t size_ = 0;
  Entry *first_ = nullptr, *last_ = nullptr, *first_fresh_ = nullptr;
  Entry *removed_ = nullptr, *last_removed_ = nullptr;
  std::vector<Entry*> changed_;
};

}  // namespace soarbox::kernel::imagery
