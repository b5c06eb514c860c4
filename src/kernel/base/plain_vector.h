// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace soarbox::kernel {

/// The default storage of a PlainVector: malloc and realloc.
struct HeapRoom {
  static void* Resize(void* records, std::size_t bytes) { return std::realloc(records, bytes); }
  static void* Copy(const HeapRoom&, const void* records, std::size_t bytes, std::size_t& capacity) {
    void* const made = std::malloc(bytes);
    if (made != nullptr) std::memcpy(made, records, bytes);
    capacity = bytes;
    return made;
  }
  static void Free(void* records) noexcept { std::free(records); }
  static void Swap(HeapRoom&) noexcept {}
};

/// A vector of trivially copyable records, for arrays that keep growing. It grows with realloc, which does not copy
/// large arrays and never needs memory for two copies. It grows by a quarter below 8 KB and by an eighth above, plus
/// 16 records, not by a factor of two like std::vector. `Room` is the storage (HeapRoom, ForkableRoom).
template <typename T, typename Room = HeapRoom>
class PlainVector {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  PlainVector() = default;
  PlainVector(const PlainVector& other) {
    if (other.size_ == 0) return;
    std::size_t bytes = 0;
    data_ = static_cast<T*>(room_.Copy(other.room_, other.data_, other.size_ * sizeof(T), bytes));
    if (data_ == nullptr) throw std::bad_alloc();
    capacity_ = bytes / sizeof(T);
    size_ = other.size_;
  }
  PlainVector(PlainVector&& other) noexcept { Swap(other); }
  PlainVector& operator=(PlainVector other) noexcept {
    Swap(other);
    return *this;
  }
  ~PlainVector() { room_.Free(data_); }

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

  /// Appends a value-initialized record.
  T& emplace_back() {
    if (size_ == capacity_) [[unlikely]] {
      Grow(size_ + 1);
    }
    return *new (data_ + size_++) T();
  }
  /// New records are value-initialized.
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
  /// Makes room for at least `capacity` records.
  void reserve(std::size_t capacity) {
    if (capacity > capacity_) Reserve(capacity);
  }
  const Room& room() const { return room_; }
  /// Releases unused memory. Never fails: if reallocation fails, nothing changes.
  void shrink_to_fit() noexcept {
    if (size_ == 0 || size_ == capacity_) {
      return;
    }
    T* const moved = static_cast<T*>(room_.Resize(static_cast<void*>(data_), size_ * sizeof(T)));
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
    room_.Swap(other.room_);
  }
  [[gnu::noinline, gnu::cold]] void Grow(std::size_t size) {
    constexpr std::size_t kLarge = std::size_t{1} << 13;  // Bytes. Growth is small because there are many agents.
    Reserve(std::max(size, capacity_ + capacity_ / (capacity_ * sizeof(T) < kLarge ? 4 : 8) + 16));
  }
  void Reserve(std::size_t capacity) {
    if (capacity == 0) {
      return;
    }
    T* const moved = static_cast<T*>(room_.Resize(static_cast<void*>(data_), capacity * sizeof(T)));
    if (moved == nullptr) {
      throw std::bad_alloc();
    }
    data_ = moved;
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  [[no_unique_address]] Room room_;
};

}  // namespace soarbox::kernel
