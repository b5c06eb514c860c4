// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

namespace soarbox::kernel {

/// Returns true if `pointer` is the only owner of its object. The caller may then change the object in place: all
/// accesses by other threads happened before this call returned.
template <typename T>
bool IsSoleOwner(const std::shared_ptr<T>& pointer) {
  if (pointer.use_count() != 1) return false;
  // Reading use_count() does not synchronize. Releasing a second handle does: it acquires what other owners released.
  std::shared_ptr<T> second = pointer;
  second.reset();
  return true;
}

}  // namespace soarbox::kernel
