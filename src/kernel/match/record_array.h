// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <type_traits>

namespace soarbox::kernel {

/// The current addresses of the records of a RecordArray: valid until the array grows.
template <typename T>
class Records {
 public:
  using Byte = std::conditional_t<std::is_const_v<T>, const char, char>;
  explicit Records(Byte* base) : base_(base) {}
  T& operator[](std::uint32_t handle) const { return *reinterpret_cast<T*>(base_ + handle); }

 private:
  Byte* base_;
};

/// A growing array of plain records for the innermost loops. A record is addressed by a 32-bit handle: its offset from
/// the start in bytes, so that following a link needs no multiplication. Records are not destroyed individually. The
/// array grows by reallocation, which does not copy large arrays.
template <typename T>
class RecordArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  RecordArray() = default;
  ~RecordArray() { std::free(data_); }
  RecordArray(const RecordArray&) = delete;
  RecordArray& operator=(const RecordArray&) = delete;

  Records<T> records() { return Records<T>(data_); }
  Records<const T> records() const { return Records<const T>(data_); }
  T& operator[](std::uint32_t handle) { return records()[handle]; }
  const T& operator[](std::uint32_t handle) const { return records()[handle]; }
  std::size_t size() const { return used_ / sizeof(T); }
  std::size_t MemoryBytes() const { return capacity_; }

  /// Frees all memory.
  void Release() {
    std::free(data_);
    data_ = nullptr;
    used_ = capacity_ = 0;
  }
  /// Limits the number of records; growing beyond it fails as if there were no memory. Existing records stay.
  void SetLimit(std::size_t records) {
    limit_ = static_cast<std::uint32_t>(std::min(records, kMostBytes / sizeof(T)) * sizeof(T));
  }
  /// True if growing failed because of the limit. (Otherwise the system had no memory.)
  bool at_limit() const { return used_ >= limit_; }
  /// Appends one record, uninitialised, and returns its handle.
  std::uint32_t Append() {
    if (used_ == capacity_) {
      Grow();
    }
    const std::uint32_t handle = used_;
    used_ += sizeof(T);
    return handle;
  }

 private:
  static constexpr std::size_t kMostBytes = 0xFFFFFFF0u;

  [[gnu::noinline, gnu::cold]] void Grow() {
    const std::size_t count = capacity_ / sizeof(T);
    const std::size_t wanted = (count < 16 ? 16 : count + count / 2) * sizeof(T);
    const std::size_t bytes = std::min<std::size_t>(wanted, limit_);
    char* moved = bytes <= capacity_ ? nullptr : static_cast<char*>(std::realloc(data_, bytes));
    if (moved == nullptr) {
      throw std::bad_alloc();
    }
    data_ = moved;
    capacity_ = static_cast<std::uint32_t>(bytes);
  }

  char* data_ = nullptr;
  std::uint32_t used_ = 0;
  std::uint32_t capacity_ = 0;
  std::uint32_t limit_ = static_cast<std::uint32_t>(kMostBytes / sizeof(T) * sizeof(T));
};

}  // namespace soarbox::kernel
