// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <cstdint>

namespace soarbox::debugger {

/// Returns a number that is unique in this process. A model changes its revision when its data change. A cache that
/// stores the revision can detect this, even if another model has been created at the same address.
inline std::uint64_t NewRevision() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace soarbox::debugger
