// SPDX-License-Identifier: BSD-2-Clause
#include "record/tick_source.h"

#include "diagnostics/problem.h"

namespace soarbox::record {

Diagnostic NotThere(const TickSource& source, std::uint64_t tick) {
  return ProblemIn(
      source.name(), "tick " + std::to_string(tick) + " is not in the recording",
      "it holds ticks " + std::to_string(source.first_tick()) + " to " + std::to_string(source.last_tick()));
}

}  // namespace soarbox::record
