// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mission/event_facts.h"
#include "mission/mission.h"

namespace soarbox::mission {

/// The state of a check.
enum class State : std::uint8_t {
  kOpen,
  kTrue,
  kFalse,
  kUntested,   ///< Its precondition never occurred. Counts as false, unless it is a marker.
  kUndecided,  ///< The data that it needs are not reported (a kernel other than ours).
};
/// "open", "true", "false", "untested", "undecided".
std::string_view NameOf(State state);

/// The result of one check in one run.
struct Verdict {
  State state = State::kOpen;
  std::uint64_t tick = 0;  ///< The tick in which the check was decided.
  double time_s = 0;
  std::string agent;  ///< The agent that decided it; empty if there is none.
  std::string was;    ///< What was found instead: "it came within 2.4 m, at 17.3 s".
};

/// Evaluates the checks of one run, tick by tick. Deterministic: the same facts give the same verdicts.
class Evaluator {
 public:
  /// `kernel_tells_all`: false for a kernel that does not report decisions.
  explicit Evaluator(const Mission& mission, bool kernel_tells_all = true);

  /// Call it for tick 0, which is the world after its set-up, and after each tick.
  void Feed(const TickFacts& facts);
  /// Call it at the end of the run. Decides all open checks.
  void Finish();

  /// One for each check, followed by one for each mistake.
  std::span<const Verdict> verdicts() const { return verdicts_; }
  /// Whether no required check is open.
  bool IsDecided() const;
  /// Whether a required check has failed. Checks with a `pass` count of their own are not considered.
  bool HasFailed() const;
  /// Whether all required checks are true, except those with a `pass` count of their own. Call it after Finish.
  bool HasPassed() const;
  /// Indices of the checks that were true before any agent acted, so that they test nothing.
  const std::vector<std::size_t>& idle_checks() const { return idle_checks_; }

 private:
  /// One check for one agent, or for several together.
  struct Slot {
    std::size_t check = 0;
    std::vector<std::size_t> subjects;  ///< Indices of agents, or of items. Empty for a check of the world, and if
                                        ///< there is no agent or item of that name.
    State state = State::kOpen;
    bool held = false;  ///< Whether the conditions were true in the previous tick.
    std::optional<double> held_since_s, opened_at_s;
    double count = 0, base = 0;       ///< kTimes: the count so far; a counter's value when the window opened.
    std::vector<double> deadlines_s;  ///< kWhenever: occurrences that still need an answer.
    double nearest = 1e30;            ///< The minimum distance in its time window.
    std::size_t most = 0;             ///< The maximum number of conditions that were true in one tick.
    double best_s = 0;
    std::string best_detail, missing;  ///< What was found in that tick.
    std::string last_agent;
  };
  struct Found {
    bool holds = false;
    double times = 0;            ///< Number of events; 1 for a state that is true.
    double value = 0;            ///< For a counter.
    double away = 1e30;          ///< Distance from being true: metres, or the difference of a gauge.
    std::size_t conditions = 0;  ///< Number of conditions that are true.
    std::string agent, detail;   ///< The agent, and what happened.
    std::string missing;         ///< The first condition that is false.
  };

  void MakeSlots(const TickFacts& facts);
  const Check& CheckAt(std::size_t index) const;
  Found Look(const Slot& slot, const Check& check, const TickFacts& facts) const;
  void Note(Slot& slot, const Check& check, const Found& found);
  void Judge(Slot& slot, const Found& found, bool rises);
  void Decide(Slot& slot, State state, std::uint64_t tick, double time_s, std::string agent, std::string was);
  struct Window {
    bool has_opened = false;
    double open_s = 0, close_s = 0;
  };
  Window WindowOf(const Check& check) const;
  std::string Miss(const Slot& slot, const Check& check) const;

  const Mission& mission_;
  Wants wants_;
  bool tells_all_;
  bool is_begun_ = false;
  std::uint64_t last_tick_ = 0;
  double last_time_s_ = 0;
  std::vector<Slot> slots_;
  std::vector<bool> is_followed_;  ///< A check with `whenever` refers to it, so that its occurrences count even after
                                   ///< it came true.
  std::vector<Verdict> verdicts_;
  std::vector<std::vector<double>> occurrences_s_;  ///< By check: times at which its conditions became true.
  std::vector<std::optional<double>> came_true_s_;  ///< By check: the time at which it was decided to be true; for
                                                    ///< `after`, `before` and `until` of other checks.
  std::vector<std::size_t> idle_checks_;
};

}  // namespace soarbox::mission
