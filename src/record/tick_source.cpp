// SPDX-License-Identifier: BSD-2-Clause
#include "record/tick_source.h"

namespace soarbox::record {

Diagnostic NotThere(const TickSource& source, std::uint64_t tick) {
  Diagnostic problem;
  problem.file = source.name();
  problem.message = "tick " + std::to_string(tick) + " is not in the recording";
  problem.hint = "it holds ticks " + std::to_string(source.first_tick()) + " to " + std::to_string(source.last_tick());
  return problem;
}

}  // namespace soarbox::record
