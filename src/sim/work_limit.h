// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::sim {

/// Maximum number of firings of a mind's rules in a tick. When it is reached, all phases of the tick end at once, and
/// the mind is halted (minds.h). It is far more than any useful program needs.
inline constexpr std::uint64_t kMostFirings = 200'000;

}  // namespace soarbox::sim
