// SPDX-License-Identifier: BSD-2-Clause
#include "record/timeline.h"

namespace soarbox::record {

Diagnostic NotThere(const Timeline& timeline, std::uint64_t tick) {
  Diagnostic problem;
  problem.file = timeline.name();
  problem.message = "tick " + std::to_string(tick) + " is not in the recording";
  problem.hint =
      "it holds ticks " + std::to_string(timeline.first_tick()) + " to " + std::to_string(timeline.last_tick());
  return problem;
}

}  // namespace soarbox::record
