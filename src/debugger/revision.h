// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <cstdint>

namespace soarbox::debugger {

/// A number that no other call in this process returns: whoever keeps it with what was read from a model can tell
/// whether that is still true, even if another model now has the same address.
inline std::uint64_t NewRevision() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace soarbox::debugger
