// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/run_event.h"

namespace soarbox::sim {

/// What kind of cause a finding names. The order is the ranking: what is certain comes before what was only tried, and
/// symptoms come last. Everything that lists what went wrong uses it: `run`, `test`, `learn check` and the panel
/// Problems.
enum class Cause : std::uint8_t {
  kBroken,    ///< Something cannot be read, or failed: a rule that does not parse, a script that stopped.
  kSlip,      ///< A slip in a rule, which shows without running it.
  kMistake,   ///< A known mistake that a rule shows, as its author wrote it.
  kEndless,   ///< Rules fire again and again in one phase.
  kRefused,   ///< The world refused a command because of how it is written.
  kFurthest,  ///< A rule that never fired, and the condition that failed when it got furthest.
  kHappened,  ///< A known mistake: something happened that should not.
  kAwaits,    ///< A rule that never fired, for want of something that may come, or because something never went.
  kStalled,   ///< An operator was applied and stays selected, so that nothing follows.
  kMissing,   ///< A known mistake: something never happened.
  kWaiting,   ///< A rule that never fired because its operator was not selected.
  kSymptom,   ///< The agent had nothing to do, or a rule that came with the lesson never fired.
};
inline constexpr Cause kLastCause = Cause::kSymptom;

/// The word for a cause in JSON: "slip", "refused", ...
std::string_view CauseName(Cause cause);

/// One sentence about what went wrong in a run.
struct Finding {
  Cause cause = Cause::kSymptom;
  std::string text;
  std::string agent = {};  ///< Empty: none, or not one alone.
  std::uint64_t tick = 0;
  double time_s = 0;
};

/// Sorts what was found by its cause; findings of one cause keep their order. The first one is the headline.
template <typename Found>
void RankByCause(std::vector<Found>& found) {
  std::ranges::stable_sort(found, {}, &Found::cause);
}

/// What kind of cause a diagnostic is. A note is none: it counts as a symptom.
Cause CauseOf(const Diagnostic& problem);

/// "porter.soar:7: what is wrong; what to do", without the folder of the file.
std::string OneLine(const Diagnostic& problem);

/// "1.0 s"
std::string SecondsText(double seconds);

/// What the events of a run show of what went wrong. It asks no mind, so it works with recordings, too.
class EventFindings {
 public:
  /// A diagnostic, once for each text.
  struct Reported {
    Finding finding;
    Diagnostic diagnostic;
  };
  /// An agent that had nothing to do, for the first time.
  struct Idle {
    std::vector<std::string> reasons;  ///< Most telling first, without what the agent perceives.
    std::string symptom;               ///< "At 3.0 s anna has nothing to do: it has done nothing for 1 s".
    std::uint64_t tick = 0;
    double time_s = 0;  ///< When it was told; that is kToldAfter_s after it began.
  };

  /// Call with the events of each tick, in order.
  void See(const EventList& events);
  void Clear() { *this = {}; }

  const std::vector<Reported>& reported() const { return reported_; }
  /// For each agent the first command that the world refused because of how it is written.
  const std::map<std::string, Finding>& refused() const { return refused_; }
  const std::map<std::string, Idle>& idle() const { return idle_; }

  /// One finding for each agent whose command was refused, and one for each that had nothing to do: the reason, or
  /// the symptom if none is known.
  std::vector<Finding> OfAgents() const;
  /// All of them, ranked.
  std::vector<Finding> Ranked() const;

  /// An agent is reported to have nothing to do when it has done nothing for this time.
  static constexpr double kToldAfter_s = 1;

 private:
  void SeeIdle(const RunEvent& event);

  std::vector<Reported> reported_;
  std::map<std::string, Finding> refused_;
  std::map<std::string, Idle> idle_;
};

/// What kind of cause a reason is that an agent had nothing to do.
Cause CauseOfReason(std::string_view reason);

}  // namespace soarbox::sim
