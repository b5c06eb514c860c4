// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace sml {

/// A pool of objects of one type. A released object stays unchanged (a dead object) until a number of others have been
/// released after it. So stale pointers to it are detected. Released objects are linked by their member `next_`, which
/// live objects may use freely.
template <typename T>
class ObjectPool {
 public:
  T* Take() {
    if (returned_count_ > kQuarantine) {
      T* const oldest = first_returned_;
      first_returned_ = static_cast<T*>(oldest->next_);
      --returned_count_;
      return oldest;
    }
    if (fresh_ == 0) {
      blocks_.emplace_back().reset(new T[kBlock]);
      fresh_ = kBlock;
    }
    return &blocks_.back()[--fresh_];
  }
  void GiveBack(T* object) {
    if (returned_count_++ == 0) {
      first_returned_ = object;
    } else {
      last_returned_->next_ = object;
    }
    last_returned_ = object;
  }

 private:
  static constexpr std::size_t kQuarantine = 32;
  static constexpr std::size_t kBlock = 8;

  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t fresh_ = 0;  ///< Objects of the last block that were never used.
  T *first_returned_ = nullptr, *last_returned_ = nullptr;
  std::size_t returned_count_ = 0;
};

}  // namespace sml
