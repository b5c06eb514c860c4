// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "world/math.h"

namespace soarbox::sim {

enum class EventKind : std::uint8_t {
  kAgentCreated,  ///< text: its kind ("lua", "soar seeking", ...) and script.
  kCommand,       ///< text: the command that a mind gave, when it differs from the one before or is news by itself.
  kOutcome,       ///< text: how a lasting command, or one that failed, ended; news: the command.
  kNews,          ///< Something that you can see in the world; news: what ("shoots", "dies", "says"); text: the rest.
  kEnded,         ///< The scenario's end is reached; text says which.
  kGap,           ///< A mind used its whole decision budget without a command; text says so. Once per gap.
  kLog,           ///< text: printed by a script or a rule.
  kDiagnostic,    ///< diagnostic: something for you to mend.
  kAgentFailed,   ///< The agent's script stopped; the world goes on.
  kMindFailed,    ///< The agent's Soar program can do nothing more; the world goes on.
  kMindLost,      ///< The connection to the minds' kernel is gone.
  kMindBack,      ///< The minds live again in a kernel that answers at the same address.
  kAnswer,        ///< text: what a command line that came in by the door printed, maybe nothing; news: the line.
};
/// The last of the kinds above; a recording refuses others.
inline constexpr EventKind kLastEventKind = EventKind::kAnswer;

/// The word for a kind in JSON and in recordings: "command", "diagnostic", ...
std::string_view EventName(EventKind kind);

/// One thing that happened, for the command line, the JSON output and the panels.
struct RunEvent {
  EventKind kind = EventKind::kLog;
  std::uint64_t tick = 0;
  double time_s = 0;
  std::string agent;  ///< Name; empty for the sandbox itself.
  std::string text;
  std::string news = {};                  ///< kNews, kOutcome: one word. kAnswer, and kDiagnostic if one failed: the
                                          ///< command line.
  std::vector<std::string> reasons = {};  ///< kGap: why, most telling first.
  std::string parameters = {};            ///< kCommand: what is below the command, if anything.
  bool has_perceived = true;              ///< kCommand: `perceived` is meant.
  Diagnostic diagnostic;                  ///< kDiagnostic, kAgentFailed and kMindFailed.
  float perceived = 0;   ///< kCommand: the ^distance that the mind saw (squared metres, as the thesis has it).
  world::Vec3 position;  ///< kCommand: where the agent stood.
};

using EventList = std::vector<RunEvent>;

}  // namespace soarbox::sim
