// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace sml {

/// Objects of one type, used again and again. One that is given back stays untouched (a husk) until a number of others
/// have been given back after it, so that a stale pointer to it is found out.
template <typename T>
class HuskPool {
 public:
  T* Take() {
    if (husk_count_ > kQuarantine) {
      T* husk = husks_[first_husk_];
      first_husk_ = (first_husk_ + 1) & (husks_.size() - 1);
      --husk_count_;
      return husk;
    }
    if (fresh_ == 0) {
      blocks_.emplace_back().reset(new T[kBlock]);
      fresh_ = kBlock;
    }
    return &blocks_.back()[--fresh_];
  }
  void GiveBack(T* object) {
    if (husk_count_ == husks_.size()) Grow();
    husks_[(first_husk_ + husk_count_) & (husks_.size() - 1)] = object;
    ++husk_count_;
  }

 private:
  static constexpr std::size_t kQuarantine = 32;
  static constexpr std::size_t kBlock = 8;

  void Grow() {
    std::vector<T*> wider(husks_.empty() ? 2 * kQuarantine : 2 * husks_.size());
    for (std::size_t i = 0; i < husk_count_; ++i) wider[i] = husks_[(first_husk_ + i) & (husks_.size() - 1)];
    husks_.swap(wider);
    first_husk_ = 0;
  }

  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t fresh_ = 0;  ///< Objects of the last block that were never taken.
  std::vector<T*> husks_;  ///< A ring, as long as a power of two.
  std::size_t first_husk_ = 0, husk_count_ = 0;
};

}  // namespace sml
