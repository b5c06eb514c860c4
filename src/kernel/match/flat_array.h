// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <type_traits>

namespace soarbox::kernel {

/// A growing array of plain records for the innermost loops: elements are addressed by 32-bit index, are never
/// destroyed one by one, and the whole moves by reallocation (which for large arrays copies nothing).
template <typename T>
class FlatArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  FlatArray() = default;
  ~FlatArray() { std::free(data_); }
  FlatArray(const FlatArray&) = delete;
  FlatArray& operator=(const FlatArray&) = delete;

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::uint32_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  T& operator[](std::uint32_t index) { return data_[index]; }
  const T& operator[](std::uint32_t index) const { return data_[index]; }

  /// Appends one record, uninitialised, and returns its index.
  std::uint32_t Append() {
    if (size_ == capacity_) {
      Grow();
    }
    return size_++;
  }

 private:
  [[gnu::noinline, gnu::cold]] void Grow() {
    const std::size_t capacity = capacity_ < 64 ? 64 : capacity_ + std::size_t{capacity_} / 2;
    void* moved = std::realloc(static_cast<void*>(data_), capacity * sizeof(T));
    if (moved == nullptr) {
      throw std::bad_alloc();
    }
    data_ = static_cast<T*>(moved);
    capacity_ = static_cast<std::uint32_t>(capacity);
  }

  T* data_ = nullptr;
  std::uint32_t size_ = 0;
  std::uint32_t capacity_ = 0;
};

}  // namespace soarbox::kernel
