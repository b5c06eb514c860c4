// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "world/math.h"

namespace soarbox::sim {

enum class EventKind : std::uint8_t {
  kAgentCreated,  ///< text: its kind ("lua", "soar seeking", ...) and script.
  kCommand,       ///< text: what a mind said, when it differs from what it said before or is news by itself.
  kGap,           ///< A mind used its whole decision budget without a command; text says so. Once per gap.
  kLog,           ///< text: printed by a script or a rule.
  kDiagnostic,    ///< diagnostic: something that a user should mend.
  kAgentFailed,   ///< The agent's script stopped; the world goes on.
  kMindFailed,    ///< The agent's Soar program can do nothing any more; the world goes on.
  kMindLost,      ///< The connection to the minds' kernel is gone.
  kMindBack,      ///< The minds live again in a kernel that answers at the same address.
};

/// One thing that happened, for the command line, the JSON output and the panels.
struct Event {
  EventKind kind = EventKind::kLog;
  std::uint64_t tick = 0;
  double time_s = 0;
  std::string agent;  ///< Name; empty for the sandbox itself.
  std::string text;
  Diagnostic diagnostic;  ///< kDiagnostic, kAgentFailed and kMindFailed.
  float perceived = 0;    ///< kCommand: the ^distance that the mind saw (squared metres, as the thesis has it).
  world::Vec3 position;   ///< kCommand: where the agent stood.
};

using EventList = std::vector<Event>;

}  // namespace soarbox::sim
