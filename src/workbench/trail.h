// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soarbox::workbench {

/// The elements that a user has visited, with a way back and forward, as in a browser. They are numbers greater than 0.
class Trail {
 public:
  /// Goes to a number. If it is the one before or after the current one, moves along the trail. Any other number
  /// replaces what comes after the current one.
  void GoTo(std::uint64_t number);
  /// The number before the current one; 0 if there is none.
  std::uint64_t before() const { return at_ > 0 ? numbers_[at_ - 1] : 0; }
  /// The number after the current one; 0 if there is none.
  std::uint64_t after() const { return at_ + 1 < numbers_.size() ? numbers_[at_ + 1] : 0; }

 private:
  std::vector<std::uint64_t> numbers_;
  std::size_t at_ = 0;
};

}  // namespace soarbox::workbench
