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

/// The kind of cause of a finding, in the order of ranking: certain causes come before failed attempts, and symptoms
/// come last. Everything that lists problems of a run uses this order: `run`, `test`, `learn check` and the panel
/// Problems.
enum class Cause : std::uint8_t {
  kBroken,    ///< A file cannot be read, a rule does not parse, or a script has stopped.
  kSlip,      ///< A slip in a rule that is found without running it.
  kMistake,   ///< A known mistake that is visible in the text of a rule.
  kEndless,   ///< Rules fire endlessly in one phase.
  kRefused,   ///< The world refused a command because its form is wrong.
  kFurthest,  ///< A rule never fired; the finding names the condition that failed in its longest partial match.
  kHappened,  ///< A known mistake: an event that should not occur.
  kAwaits,    ///< A rule never fired because an element was never added, or never removed.
  kStalled,   ///< An operator was applied and stays selected, so that nothing follows.
  kMissing,   ///< A known mistake: an event that did not occur.
  kWaiting,   ///< A rule never fired because its operator was not selected.
  kSymptom,   ///< The agent had nothing to do, or a rule of the lesson never fired.
};
inline constexpr Cause kLastCause = Cause::kSymptom;

/// The word for a cause in JSON: "slip", "refused", ...
std::string_view CauseName(Cause cause);

/// One sentence about a problem of a run.
struct Finding {
  Cause cause = Cause::kSymptom;
  std::string text;
  std::string agent = {};  ///< Empty if the finding is not about one particular agent.
  std::uint64_t tick = 0;
  double time_s = 0;
  std::string rule = {};  ///< The rule that it is about; may be empty.
  Topic topic = Topic::kOther;
};

/// Sorts findings by cause. Findings with the same cause keep their order. The first one is the headline.
template <typename Found>
void RankByCause(std::vector<Found>& found) {
  std::ranges::stable_sort(found, {}, &Found::cause);
}

/// The cause of a diagnostic. A note is a symptom.
Cause CauseOf(const Diagnostic& problem);

/// "porter.soar:7: problem; hint", without the folder of the file.
std::string OneLine(const Diagnostic& problem);

/// "1.0 s"
std::string SecondsText(double seconds);

/// Finds problems in the events of a run. It does not query minds, so it also works with recordings.
class EventFindings {
 public:
  /// A diagnostic. Each text is listed once.
  struct Reported {
    Finding finding;
    Diagnostic diagnostic;
  };
  /// The first time that an agent had nothing to do.
  struct Idle {
    std::vector<explain::Reason> reasons;  ///< The most informative first, without the agent's percepts.
    std::string symptom;                   ///< "At 3.0 s anna has nothing to do: it has done nothing for 1 s".
    std::uint64_t tick = 0;
    double time_s = 0;  ///< Time of the report; kToldAfter_s after the agent became idle.
  };

  /// Call it with the events of each tick, in order.
  void See(const EventList& events);
  void Clear() { *this = {}; }

  const std::vector<Reported>& reported() const { return reported_; }
  /// For each agent, the first command that the world refused because its form is wrong.
  const std::map<std::string, Finding>& refused() const { return refused_; }
  const std::map<std::string, Idle>& idle() const { return idle_; }

  /// One finding for each agent whose command was refused, and one for each agent that was idle: the reason, or the
  /// symptom if no reason is known.
  std::vector<Finding> OfAgents() const;
  /// All findings, ranked.
  std::vector<Finding> Ranked() const;

  /// An agent is reported as idle after this time without an action, in s.
  static constexpr double kToldAfter_s = 1;

 private:
  void SeeIdle(const RunEvent& event);

  std::vector<Reported> reported_;
  std::map<std::string, Finding> refused_;
  std::map<std::string, Idle> idle_;
};

/// The cause that a reason for an idle agent belongs to.
Cause CauseOf(const explain::Reason& reason);

}  // namespace soarbox::sim
