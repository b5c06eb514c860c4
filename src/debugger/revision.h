// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <cstdint>

namespace soarbox::debugger {

/// A number that no other call in this process returns: who keeps what he read from a model, and its number, knows
/// whether it is still so, even if another model has come to the same place in memory.
inline std::uint64_t NewRevision() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace soarbox::debugger
