// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_memory.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <new>
#include <utility>

#include "script/script_pages.h"
#include "script/world_budget.h"

namespace soarbox::script {
namespace {

constexpr std::size_t kSmallestSharedChunk = std::size_t{32} * 1024;
constexpr std::size_t kLargestSharedChunk = std::size_t{1024} * 1024;

}  // namespace

std::size_t ScriptMemory::ClassOf(std::size_t size) {
  if (size <= kSmallLimit) return (size + kSmallStep - 1) / kSmallStep - 1;
  const auto doubling = static_cast<std::size_t>(std::bit_width((size - 1) / kSmallLimit)) - 1;
  const std::size_t step = (kSmallLimit / kPerDoubling) << doubling;
  return kSmallClasses + kPerDoubling * doubling + (size - 1) / step % kPerDoubling;
}

std::size_t ScriptMemory::SizeOfClass(std::size_t size_class) {
  if (size_class < kSmallClasses) return (size_class + 1) * kSmallStep;
  const std::size_t doubling = (size_class - kSmallClasses) / kPerDoubling;
  const std::size_t part = (size_class - kSmallClasses) % kPerDoubling;
  return (kSmallLimit / kPerDoubling * (kPerDoubling + part + 1)) << doubling;
}

void* ScriptMemory::Take(std::size_t size_class) {
  if (FreeBlock* block = free_[size_class]) {
    free_[size_class] = block->next;
    return block;
  }
  const std::size_t size = SizeOfClass(size_class);
  if (rest_ < size) {
    const bool own_chunk = size > next_chunk_size_ / 4;
    const std::size_t chunk_size = own_chunk ? size : next_chunk_size_;
    world_refused_ = world_ != nullptr && !world_->TakeMemory(chunk_size, reserved_bytes_);
    if (world_refused_) return nullptr;
    const bool was_near = world_ != nullptr && world_->IsNearShare(reserved_bytes_);
    reserved_bytes_ += chunk_size;
    near_refusal_ |= world_ != nullptr && !was_near && world_->IsNearShare(reserved_bytes_);
    if (chunks_.size() == chunks_.capacity()) chunks_.reserve(2 * chunks_.size() + 4);  // Code below must not throw.
    Chunk chunk{std::unique_ptr<std::byte[]>(TakePages(chunk_size)), chunk_size, own_chunk ? chunk_size : 0};
    if (!chunk.bytes) {
      if (world_ != nullptr) world_->GiveMemoryBack(chunk_size);
      reserved_bytes_ -= chunk_size;
      return nullptr;
    }
    chunks_.push_back(std::move(chunk));
    std::byte* start = chunks_.back().bytes.get();
    if (own_chunk) return start;
    next_ = start;
    rest_ = chunk_size;
    shared_chunk_ = chunks_.size() - 1;
    // Grows by a quarter each time, so that a small machine uses nearly all of its memory.
    next_chunk_size_ = std::clamp(std::bit_floor(reserved_bytes_ / 4), kSmallestSharedChunk, kLargestSharedChunk);
  }
  void* block = next_;
  next_ += size;
  rest_ -= size;
  chunks_[shared_chunk_].handed_out += size;
  return block;
}

void ScriptMemory::GiveBack(void* block, std::size_t size_class) {
  auto& list = (collecting_ ? waiting_ : free_)[size_class];
  auto* free_block = static_cast<FreeBlock*>(block);
  free_block->next = list;
  list = free_block;
}

void ScriptMemory::EndCollection() {
  collecting_ = false;
  for (std::size_t size_class = 0; size_class < kClasses; ++size_class)
    if (waiting_[size_class] != nullptr) PutInOrder(size_class);
}

void ScriptMemory::PutInOrder(std::size_t size_class) {
  std::vector<std::pair<std::uint64_t, FreeBlock*>> blocks;
  for (FreeBlock* block = waiting_[size_class]; block != nullptr; block = block->next)
    blocks.emplace_back(OrderOf(block), block);
  waiting_[size_class] = nullptr;
  // The first block in order is used first.
  std::sort(blocks.begin(), blocks.end(), std::greater<>());
  for (const auto& [order, block] : blocks) GiveBack(block, size_class);
}

void ScriptMemory::ReleaseFreeChunks() {
  std::vector<std::pair<const std::byte*, std::size_t>> starts;  // With the chunk's index, sorted by address.
  for (std::size_t i = 0; i < chunks_.size(); ++i)
    if (chunks_[i].bytes) starts.emplace_back(chunks_[i].bytes.get(), i);
  std::sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return std::less<>()(a.first, b.first); });
  const auto chunk_of = [&](const FreeBlock* block) {
    const auto* address = reinterpret_cast<const std::byte*>(block);
    const auto after =
        std::upper_bound(starts.begin(), starts.end(), address,
                         [](const std::byte* wanted, const auto& start) { return std::less<>()(wanted, start.first); });
    return std::prev(after)->second;
  };
  std::vector<std::size_t> free_bytes(chunks_.size());
  for (std::size_t size_class = 0; size_class < kClasses; ++size_class)
    for (const FreeBlock* block = free_[size_class]; block != nullptr; block = block->next)
      free_bytes[chunk_of(block)] += SizeOfClass(size_class);
  const auto is_released = [&](std::size_t chunk) {
    return chunks_[chunk].bytes != nullptr && free_bytes[chunk] == chunks_[chunk].handed_out;
  };
  // Blocks of kept chunks keep their order.
  for (FreeBlock*& list : free_) {
    FreeBlock** link = &list;
    while (*link != nullptr) {
      if (is_released(chunk_of(*link))) {
        *link = (*link)->next;
      } else {
        link = &(*link)->next;
      }
    }
  }
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    if (!is_released(i)) continue;
    if (i == shared_chunk_) rest_ = 0;
    GivePagesBack(chunks_[i].bytes.release(), chunks_[i].size);
    if (world_ != nullptr) world_->GiveMemoryBack(chunks_[i].size);
    reserved_bytes_ -= chunks_[i].size;
    chunks_[i] = {};  // Later chunks keep their indices, because OrderOf depends on them.
  }
}

ScriptMemory::~ScriptMemory() {
  for (Chunk& chunk : chunks_)
    if (chunk.bytes) GivePagesBack(chunk.bytes.release(), chunk.size);
  if (world_ != nullptr) world_->GiveMemoryBack(reserved_bytes_);
}

void* ScriptMemory::Reallocate(void* block, std::size_t old_size, std::size_t new_size) {
  if (!block) old_size = 0;
  if (block == watched_) watched_ = nullptr;
  if (new_size == 0) {
    if (block && old_size > 0) {
      GiveBack(block, ClassOf(old_size));
      used_bytes_ -= old_size;
    }
    return nullptr;
  }
  // Shrinking must always succeed, even above the limit.
  if (new_size > old_size && new_size - old_size + used_bytes_ > limit_bytes_) return nullptr;
  const std::size_t new_class = ClassOf(new_size);
  if (new_class >= kClasses) return nullptr;
  if (old_size == 0 || ClassOf(old_size) != new_class) {
    void* moved = Take(new_class);
    if (!moved) return new_size <= old_size ? block : nullptr;
    if (old_size > 0) {
      std::memcpy(moved, block, std::min(old_size, new_size));
      GiveBack(block, ClassOf(old_size));
    }
    block = moved;
  }
  used_bytes_ += new_size - old_size;
  if (old_size == 0) {
    last_block_ = block;
    last_size_ = new_size;
  }
  return block;
}

std::uint64_t ScriptMemory::OrderOf(const void* address) const {
  const auto* byte = static_cast<const std::byte*>(address);
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    const std::byte* start = chunks_[i].bytes.get();
    // Addresses in different chunks are compared as integers.
    const auto offset = reinterpret_cast<std::uintptr_t>(byte) - reinterpret_cast<std::uintptr_t>(start);
    if (reinterpret_cast<std::uintptr_t>(byte) >= reinterpret_cast<std::uintptr_t>(start) && offset < chunks_[i].size)
      return (static_cast<std::uint64_t>(i + 1) << 32) + offset;
  }
  return 0;
}

}  // namespace soarbox::script
