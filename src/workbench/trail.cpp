// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/trail.h"

namespace soarbox::workbench {

void Trail::GoTo(std::uint64_t number) {
  constexpr std::size_t kMost = 200;
  if (number == 0 || (!numbers_.empty() && numbers_[at_] == number)) return;
  if (number == before()) {
    --at_;
  } else if (number == after()) {
    ++at_;
  } else {
    if (!numbers_.empty()) numbers_.resize(at_ + 1);
    numbers_.push_back(number);
    if (numbers_.size() > kMost) numbers_.erase(numbers_.begin());
    at_ = numbers_.size() - 1;
  }
}

}  // namespace soarbox::workbench
