// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <type_traits>
#include <vector>

namespace soarbox::kernel {

/// Memory for temporary objects that are all freed at once. An allocation moves a pointer; the first 16 KB are inside
/// the arena itself. Only for trivially destructible types. Objects never move.
class Arena {
 public:
  Arena() : next_(first_), end_(first_ + sizeof(first_)) {}
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  template <typename T>
  T* New(const T& value) {
    static_assert(std::is_trivially_destructible_v<T>);
    return new (Take(sizeof(T), alignof(T))) T(value);
  }
  template <typename T>
  T* New() {
    static_assert(std::is_trivially_destructible_v<T>);
    return new (Take(sizeof(T), alignof(T))) T();
  }
  /// Returns `count` value-initialized objects.
  template <typename T>
  T* NewArray(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    T* const made = static_cast<T*>(Take(sizeof(T) * count, alignof(T)));
    std::uninitialized_value_construct_n(made, count);
    return made;
  }
  /// Returns uninitialized memory for `count` objects, which the caller must construct.
  template <typename T>
  T* NewRoom(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    return static_cast<T*>(Take(sizeof(T) * count, alignof(T)));
  }
  std::string_view Copy(std::string_view text) {
    char* const made = static_cast<char*>(Take(text.size(), 1));
    text.copy(made, text.size());
    return {made, text.size()};
  }

  /// Frees all objects, and all memory except the first block, which is part of the arena.
  void Clear() {
    blocks_.clear();
    next_ = first_;
    end_ = first_ + sizeof(first_);
  }

 private:
  static constexpr std::size_t kFirstBytes = 16 * 1024, kBlockBytes = 64 * 1024;

  void* Take(std::size_t bytes, std::size_t alignment) {
    const std::size_t padding = (0u - reinterpret_cast<std::uintptr_t>(next_)) & (alignment - 1);
    if (static_cast<std::size_t>(end_ - next_) < bytes + padding) {
      return TakeFromNewBlock(bytes);
    }
    std::byte* const place = next_ + padding;
    next_ = place + bytes;
    return place;
  }
  [[gnu::noinline]] void* TakeFromNewBlock(std::size_t bytes) {
    const std::size_t size = std::max(bytes, kBlockBytes);
    blocks_.push_back(std::make_unique_for_overwrite<std::byte[]>(size));
    next_ = blocks_.back().get() + bytes;
    end_ = blocks_.back().get() + size;
    return blocks_.back().get();
  }

  std::byte* next_;
  std::byte* end_;
  std::vector<std::unique_ptr<std::byte[]>> blocks_;
  alignas(std::max_align_t) std::byte first_[kFirstBytes];
};

}  // namespace soarbox::kernel
