// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace soarbox::world {

/// A list with ascending ids, stored in blocks that copies share. A copy costs a pointer per block; a later change
/// copies one block. Lists that share a block have equal contents there, without a comparison.
///
/// Copies can be used on different threads; each one by one thread at a time. References and iterators are valid until
/// the list changes.
template <typename T>
class SharedList {
 public:
  static constexpr std::size_t kMostPerBlock = 32;

  /// Position of an entry, or the position after the last one.
  struct Place {
    std::size_t block = 0;
    std::size_t index = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };

  class const_iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = const T&;
    const_iterator() = default;
    const_iterator(const SharedList& list, Place place) : list_(&list), place_(place) {}
    reference operator*() const { return list_->At(place_); }
    pointer operator->() const { return &list_->At(place_); }
    const_iterator& operator++() {
      place_ = list_->After(place_);
      return *this;
    }
    const_iterator operator++(int) { return {*list_, std::exchange(place_, list_->After(place_))}; }
    friend bool operator==(const const_iterator& a, const const_iterator& b) { return a.place_ == b.place_; }

   private:
    const SharedList* list_ = nullptr;
    Place place_;
  };

  SharedList() = default;
  SharedList(const SharedList&) = default;
  SharedList(SharedList&& other) noexcept : blocks_(std::move(other.blocks_)), size_(std::exchange(other.size_, 0)) {}
  SharedList& operator=(const SharedList&) = default;
  SharedList& operator=(SharedList&& other) noexcept {
    blocks_ = std::move(other.blocks_);
    size_ = std::exchange(other.size_, 0);
    return *this;
  }
  ~SharedList() = default;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const_iterator begin() const { return {*this, {}}; }
  const_iterator end() const { return {*this, End()}; }
  const T& front() const { return At({}); }
  const T& back() const { return blocks_.back()->entries.back(); }
  /// Walks the blocks: linear in their number.
  const T& operator[](std::size_t index) const {
    std::size_t block = 0;
    for (; index >= blocks_[block]->entries.size(); ++block) index -= blocks_[block]->entries.size();
    return blocks_[block]->entries[index];
  }

  const T& At(Place place) const { return blocks_[place.block]->entries[place.index]; }
  Place After(Place place) const {
    return ++place.index < blocks_[place.block]->entries.size() ? place : Place{place.block + 1, 0};
  }
  Place End() const { return {blocks_.size(), 0}; }
  bool IsEnd(Place place) const { return place.block == blocks_.size(); }
  /// The first entry with this id or a greater one. Fast if it is at the hint or directly after it.
  Place Find(std::uint32_t id, Place hint = {}) const {
    for (int i = 0; i < 2 && hint.block < blocks_.size() && hint.index < blocks_[hint.block]->entries.size(); ++i) {
      if (At(hint).id == id) return hint;
      hint = After(hint);
    }
    const auto block = std::partition_point(blocks_.begin(), blocks_.end(),
                                            [id](const Handle& b) { return b->entries.back().id < id; });
    if (block == blocks_.end()) return End();
    const auto entry = std::partition_point((*block)->entries.begin(), (*block)->entries.end(),
                                            [id](const T& e) { return e.id < id; });
    return {static_cast<std::size_t>(block - blocks_.begin()),
            static_cast<std::size_t>(entry - (*block)->entries.begin())};
  }
  /// Whether both blocks share the same memory and are therefore equal.
  bool SharesBlock(std::size_t block, const SharedList& other, std::size_t other_block) const {
    return blocks_[block].get() == other.blocks_[other_block].get();
  }
  std::size_t BlockSize(std::size_t block) const { return blocks_[block]->entries.size(); }

  /// Access to change an entry. Its id must not be changed.
  T& Edit(Place place) { return Own(place.block).entries[place.index]; }
  /// The id must be greater than that of the last entry.
  void push_back(T value) {
    if (blocks_.empty() || blocks_.back()->entries.size() >= kMostPerBlock) blocks_.emplace_back(new Block);
    Own(blocks_.size() - 1).entries.push_back(std::move(value));
    ++size_;
  }
  /// Inserts before the entry at a position. Returns the position of the new entry.
  Place Insert(Place place, T value) {
    if (IsEnd(place)) {
      push_back(std::move(value));
      return {blocks_.size() - 1, blocks_.back()->entries.size() - 1};
    }
    if (BlockSize(place.block) >= kMostPerBlock) place = Split(place);
    auto& entries = Own(place.block).entries;
    entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(place.index), std::move(value));
    ++size_;
    return place;
  }
  /// Returns the position of the following entry.
  Place Erase(Place place) {
    auto& entries = Own(place.block).entries;
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(place.index));
    --size_;
    if (entries.empty()) {
      blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(place.block));
      return {place.block, 0};
    }
    return place.index < entries.size() ? place : Place{place.block + 1, 0};
  }
  void clear() {
    blocks_.clear();
    size_ = 0;
  }

 private:
  struct Block {
    std::atomic<std::uint32_t> holders{1};
    std::vector<T> entries;  ///< 1 to kMostPerBlock.
  };

  /// Counts references, so that any thread can check whether a block is shared.
  class Handle {
   public:
    explicit Handle(Block* block) : block_(block) {}
    Handle(const Handle& other) : block_(other.block_) { block_->holders.fetch_add(1, std::memory_order_relaxed); }
    Handle(Handle&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
    ~Handle() { Drop(); }
    Handle& operator=(const Handle& other) {
      if (block_ != other.block_) *this = Handle(other);
      return *this;
    }
    Handle& operator=(Handle&& other) noexcept {
      if (this != &other) {
        Drop();
        block_ = std::exchange(other.block_, nullptr);
      }
      return *this;
    }
    Block* operator->() const { return block_; }
    Block& operator*() const { return *block_; }
    Block* get() const { return block_; }
    bool IsAlone() const { return block_->holders.load(std::memory_order_acquire) == 1; }

   private:
    void Drop() {
      if (block_ != nullptr && block_->holders.fetch_sub(1, std::memory_order_acq_rel) == 1) delete block_;
    }
    Block* block_;
  };

  Block& Own(std::size_t block) {
    Handle& handle = blocks_[block];
    if (handle.IsAlone()) return *handle;
    auto* own = new Block;
    own->entries.reserve(handle->entries.size() < kMostPerBlock ? handle->entries.size() + 1 : kMostPerBlock);
    own->entries.assign(handle->entries.begin(), handle->entries.end());
    handle = Handle(own);
    return *own;
  }

  /// Splits a full block into two. Returns the new position of the entry.
  Place Split(Place place) {
    auto& entries = Own(place.block).entries;
    const std::size_t half = entries.size() / 2;
    auto* second = new Block;
    const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(half);
    second->entries.assign(std::make_move_iterator(middle), std::make_move_iterator(entries.end()));
    entries.erase(middle, entries.end());
    blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(place.block) + 1, Handle(second));
    return place.index <= half ? place : Place{place.block + 1, place.index - half};
  }

  std::vector<Handle> blocks_;
  std::size_t size_ = 0;
};

}  // namespace soarbox::world
