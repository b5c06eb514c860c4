// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// A complete match of a rule (a token that reached its production node), from the moment it appears until both it is
/// gone and its instantiation has been retracted. Handles are used again after that.
enum class MatchId : std::uint32_t { kNone = 0xFFFFFFFFu };

enum class MatchState : std::uint8_t {
  kFree,
  kPendingAssertion,   ///< Matched, not fired yet.
  kFired,              ///< Has an instantiation.
  kPendingRetraction,  ///< No longer matches; its instantiation is to be retracted.
};

}  // namespace soarbox::kernel
