// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace sml {

/// Objects of one type, used again and again. One that is given back stays untouched (a dead object) until a number of
/// others have been given back after it, so that a stale pointer to it is found out.
template <typename T>
class ObjectPool {
 public:
  T* Take() {
    if (returned_count_ > kQuarantine) {
      T* oldest = returned_[first_returned_];
      first_returned_ = (first_returned_ + 1) & (returned_.size() - 1);
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
    if (returned_count_ == returned_.size()) Grow();
    returned_[(first_returned_ + returned_count_) & (returned_.size() - 1)] = object;
    ++returned_count_;
  }

 private:
  static constexpr std::size_t kQuarantine = 32;
  static constexpr std::size_t kBlock = 8;

  void Grow() {
    std::vector<T*> wider(returned_.empty() ? 2 * kQuarantine : 2 * returned_.size());
    for (std::size_t i = 0; i < returned_count_; ++i)
      wider[i] = returned_[(first_returned_ + i) & (returned_.size() - 1)];
    returned_.swap(wider);
    first_returned_ = 0;
  }

  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t fresh_ = 0;     ///< Objects of the last block that were never taken.
  std::vector<T*> returned_;  ///< A ring, as long as a power of two.
  std::size_t first_returned_ = 0, returned_count_ = 0;
};

}  // namespace sml
