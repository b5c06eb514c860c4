// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace soarbox::kernel {

/// Room for one more in a vector of which an agent has many entries for long: it grows by a quarter when it is large,
/// where std::vector would double.
template <typename T>
void MakeRoom(std::vector<T>& list) {
  constexpr std::size_t kLarge = 128;
  if (list.size() == list.capacity() && list.size() >= kLarge) list.reserve(list.size() + list.size() / 4);
}

}  // namespace soarbox::kernel
