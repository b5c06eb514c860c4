// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace soarbox::world {

/// Fills a list again in place of what it held, so that its entries' texts and lists keep their memory. Entries that
/// are left over go at the end.
template <typename T>
class Refill {
 public:
  Refill(std::vector<T>& list, std::size_t most) : list_(list) { list_.reserve(most); }
  ~Refill() { list_.resize(used_); }
  Refill(const Refill&) = delete;
  Refill& operator=(const Refill&) = delete;

  /// The next entry, to be assigned to as a whole. Valid until the next call.
  T& Next() {
    if (used_ == list_.size()) list_.emplace_back();
    return list_[used_++];
  }

 private:
  std::vector<T>& list_;
  std::size_t used_ = 0;
};

}  // namespace soarbox::world
