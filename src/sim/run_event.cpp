// SPDX-License-Identifier: BSD-2-Clause
#include "sim/run_event.h"

#include "diagnostics/name_table.h"

namespace soarbox::sim {

std::string_view EventName(EventKind kind) {
  static constexpr const char* kNames[] = {"agent",      "command", "outcome", "news", "reached", "gap",   "log",
                                           "diagnostic", "failed",  "failed",  "lost", "back",    "answer"};
  return NameIn(kNames, kind);
}

}  // namespace soarbox::sim
