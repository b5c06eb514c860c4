// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace soarbox::world {

/// Refills a list in place, so that texts and lists in its entries keep their allocated memory. The destructor removes
/// the entries that were not refilled.
template <typename T>
class Refill {
 public:
  Refill(std::vector<T>& list, std::size_t most) : list_(list) { list_.reserve(most); }
  ~Refill() { list_.resize(used_); }
  Refill(const Refill&) = delete;
  Refill& operator=(const Refill&) = delete;

  /// The next entry; the caller must assign all its members. Valid until the next call.
  T& Next() {
    if (used_ == list_.size()) list_.emplace_back();
    return list_[used_++];
  }

 private:
  std::vector<T>& list_;
  std::size_t used_ = 0;
};

}  // namespace soarbox::world
