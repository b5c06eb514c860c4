// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mission/facts.h"
#include "mission/mission.h"

namespace soarbox::mission {

/// How a check stands.
enum class State : std::uint8_t {
  kOpen,
  kTrue,
  kFalse,
  kUntested,   ///< What it waits for never came: counts as false, unless that is a marker.
  kUndecided,  ///< The facts that it asks for are not told (a kernel that is not ours).
};
/// "open", "true", "false", "untested", "undecided".
std::string_view NameOf(State state);

/// What came of one check in one run.
struct Verdict {
  State state = State::kOpen;
  std::uint64_t tick = 0;  ///< When it was decided; of a check that came too late, where it was nearest.
  double time_s = 0;
  std::string agent;  ///< Who decided it; empty: nobody in particular.
  std::string was;    ///< What was there instead: "it came within 2.4 m, at 17.3 s".
};

/// Decides the checks of one run, tick by tick. Deterministic: the same facts give the same verdicts.
class Evaluator {
 public:
  /// `kernel_tells_all`: false for a kernel that does not report decisions.
  explicit Evaluator(const Mission& mission, bool kernel_tells_all = true);

  /// Call once for tick 0, the world as it was set up, and after each tick.
  void Feed(const TickFacts& facts);
  /// The run is over: what is still open is decided.
  void Finish();

  /// One for each check, and behind them one for each mistake.
  std::span<const Verdict> verdicts() const { return verdicts_; }
  /// No required check is open.
  bool IsDecided() const;
  /// A required check that is not counted by itself has failed.
  bool HasFailed() const;
  /// True if all required checks are true, except those that are counted by themselves; call after Finish.
  bool HasPassed() const;
  /// Checks that held before anybody acted, so that they test nothing, by their index.
  const std::vector<std::size_t>& idle_checks() const { return idle_checks_; }

 private:
  /// One check of one agent, or of several together.
  struct Slot {
    std::size_t check = 0;
    std::vector<std::size_t> subjects;  ///< Indices of agents; of an item its index; empty: the world.
    State state = State::kOpen;
    bool held = false;  ///< In the tick before.
    std::optional<double> held_since_s, opened_at_s;
    double count = 0, base = 0;
    std::vector<double> deadlines_s;  ///< kWhenever: occurrences that wait for an answer.
    double nearest = 1e30;            ///< The closest that it came, in its window.
    std::size_t most = 0;             ///< The most conditions that held in one tick.
    std::uint64_t best_tick = 0;
    double best_s = 0;
    std::string best_detail, missing;  ///< What was there then.
    std::string last_agent;
  };
  struct Found {
    bool holds = false;
    double times = 0;            ///< Events; 1 for a state that holds.
    double value = 0;            ///< Of a counter.
    double away = 1e30;          ///< How far from it: metres, or a gauge's difference.
    std::size_t conditions = 0;  ///< That hold.
    std::string agent, detail;   ///< Who; what it was.
    std::string missing;         ///< The first condition that does not hold.
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
  std::vector<bool> is_followed_;  ///< By a check with `whenever`: its occurrences count after it came true, too.
  std::vector<Verdict> verdicts_;
  std::vector<std::vector<double>> occurrences_s_;  ///< Of each check: when its conditions came to hold.
  std::vector<std::optional<double>> came_true_s_;  ///< Of each check: the first time; for others' `after`.
  std::vector<std::size_t> idle_checks_;
};

}  // namespace soarbox::mission
