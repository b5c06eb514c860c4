// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/reason.h"
#include "world/math.h"

namespace soarbox::sim {

enum class EventKind : std::uint8_t {
  kAgentCreated,  ///< text: its kind ("lua", "soar seeking", ...) and its script.
  kCommand,       ///< text: the command of a mind, if it differs from the previous one or is important by itself.
  kOutcome,       ///< text: the result of a command that took time or failed; news: the command.
  kNews,          ///< Something visible in the world; news: what ("shoots", "dies", "says"); text: the details.
  kEnded,         ///< The scenario has reached its end; text: which one.
  kGap,           ///< text: a mind used its entire decision budget without a command. Reported once per idle period.
  kLog,           ///< text: output of a script or a rule.
  kDiagnostic,    ///< diagnostic: a problem for the user to correct.
  kAgentFailed,   ///< The agent's script stopped; the world continues.
  kMindFailed,    ///< The agent's Soar program has ended; the world continues.
  kMindLost,      ///< The connection to the minds' kernel is lost.
  kMindBack,      ///< The minds were created again in a kernel at the same address.
  kAnswer,        ///< text: output of a command line from an input, possibly empty; news: the line.
};
/// The last kind; a recording refuses greater values.
inline constexpr EventKind kLastEventKind = EventKind::kAnswer;

/// The word for a kind in JSON and in recordings: "command", "diagnostic", ...
std::string_view EventName(EventKind kind);

/// What an agent said (kNews, "says").
struct Speech {
  std::string to;  ///< An agent, or "team red".
  std::string about, text;
};
/// The state of a check of the run's mission (kNews, "check"). The event's text is the name of the check, its
/// parameters are the state.
struct CheckReport {
  std::string expected;
  std::string was;    ///< What was found instead.
  std::string agent;  ///< The agent that decided it; may be empty.
  bool is_marker = false;
};

/// An event of a run, for the command line, the JSON output and the panels.
struct RunEvent {
  EventKind kind = EventKind::kLog;
  std::uint64_t tick = 0;
  double time_s = 0;
  std::string agent;  ///< Name of the agent; empty for the sandbox.
  std::string text;
  std::string news = {};  ///< kNews, kOutcome: one word. kAnswer, and kDiagnostic of a failed command:
                          ///< the command line.
  std::vector<explain::Reason> reasons = {};  ///< kGap: the most informative first. kOutcome: a fault of its form.
  std::string parameters = {};                ///< kCommand: the parameters of the command.
  std::variant<std::monostate, Speech, CheckReport> values = {};  ///< kNews: what the text says, as values.
  bool has_perceived = true;                                      ///< kCommand: whether `perceived` is set.
  Diagnostic diagnostic;                                          ///< kDiagnostic, kAgentFailed and kMindFailed.
  float perceived = 0;   ///< kCommand: the ^distance that the mind perceived (squared metres, as in the thesis).
  world::Vec3 position;  ///< kCommand: position of the agent.
};

using EventList = std::vector<RunEvent>;

/// The sentences that explain an event: its reasons; or what a check expected and what was found.
std::vector<std::string> Remarks(const RunEvent& event);

}  // namespace soarbox::sim
