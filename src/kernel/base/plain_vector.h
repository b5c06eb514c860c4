// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace soarbox::kernel {

/// A vector of plain records for arrays that grow for long and large. It moves by reallocation, which for large arrays
/// copies nothing and never holds two copies, and grows by an eighth when it is large, where std::vector would double.
template <typename T>
class PlainVector {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  PlainVector() = default;
  PlainVector(const PlainVector& other) {
    Reserve(other.size_);
    std::uninitialized_copy(other.begin(), other.end(), data_);
    size_ = other.size_;
  }
  PlainVector(PlainVector&& other) noexcept { Swap(other); }
  PlainVector& operator=(PlainVector other) noexcept {
    Swap(other);
    return *this;
  }
  ~PlainVector() { std::free(data_); }

  T& operator[](std::size_t index) { return data_[index]; }
  const T& operator[](std::size_t index) const { return data_[index]; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }

  /// Appends a record made by default.
  T& emplace_back() {
    if (size_ == capacity_) [[unlikely]] {
      Grow(size_ + 1);
    }
    return *new (data_ + size_++) T();
  }
  /// New records are made by default.
  void resize(std::size_t size) {
    if (size > capacity_) {
      Grow(size);
    }
    if (size > size_) {
      std::uninitialized_value_construct(data_ + size_, data_ + size);
    }
    size_ = size;
  }
  void clear() { size_ = 0; }
  /// Gives back what is not in use. Never fails: at worst all stays as it is.
  void shrink_to_fit() noexcept {
    if (size_ == 0 || size_ == capacity_) {
      return;
    }
    T* const moved = static_cast<T*>(std::realloc(static_cast<void*>(data_), size_ * sizeof(T)));
    if (moved != nullptr) {
      data_ = moved;
      capacity_ = size_;
    }
  }

  friend bool operator==(const PlainVector& a, const PlainVector& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  void Swap(PlainVector& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }
  [[gnu::noinline, gnu::cold]] void Grow(std::size_t size) {
    constexpr std::size_t kLarge = std::size_t{1} << 18;  // Bytes.
    Reserve(std::max(size, capacity_ + capacity_ / (capacity_ * sizeof(T) < kLarge ? 4 : 8) + 16));
  }
  void Reserve(std::size_t capacity) {
    if (capacity == 0) {
      return;
    }
    T* const moved = static_cast<T*>(std::realloc(static_cast<void*>(data_), capacity * sizeof(T)));
    if (moved == nullptr) {
      throw std::bad_alloc();
    }
    data_ = moved;
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace soarbox::kernel
