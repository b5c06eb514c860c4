// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

namespace soarbox::kernel {

/// True if nobody else holds what `pointer` points to. You may then change it in place: whatever other threads did with
/// it has happened before.
template <typename T>
bool IsSoleOwner(const std::shared_ptr<T>& pointer) {
  if (pointer.use_count() != 1) return false;
  // Reading the count orders nothing. Letting go of a second handle does: it acquires what the others' release left.
  std::shared_ptr<T> second = pointer;
  second.reset();
  return true;
}

}  // namespace soarbox::kernel
