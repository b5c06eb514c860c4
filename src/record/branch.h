// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "record/compare.h"
#include "record/rerun.h"
#include "record/tick_source.h"

namespace soarbox::record {

/// Goes back to a tick and continues from there. Simulates a run again up to one of its ticks, in slices so that a
/// window stays responsive, and then becomes a live simulation whose future may differ. The records of the old future
/// stay where they are, for comparison.
///
///     Result<std::unique_ptr<Branch>> branch = Branch::Begin(history, scenario, settings, tick);
///     while (!(*branch)->IsThere()) if (const auto gone = (*branch)->Advance(20); !gone) ...;
///     simulation = (*branch)->TakeSimulation();      // Submit edits, Tick, look into minds
///     Futures futures = (*branch)->CompareFutures(); // See each of its ticks
///
/// The timeline must outlive the branch and everything made from it, and may grow meanwhile. One thread at a time.
class Branch {
 public:
  /// From a running world: its scenario and the settings that it was made with. Debuggers cannot attach to the branch.
  static Result<std::unique_ptr<Branch>> Begin(TickSource& past, const sim::Scenario& scenario,
                                               const sim::SimulationSettings& settings, std::uint64_t tick);
  /// From a recording, whose scenario is searched for again. `threads`: for the minds; 0: one per core.
  static Result<std::unique_ptr<Branch>> Begin(TickSource& past, const sim::DataFolders& data, std::uint64_t tick,
                                               int threads = 0);

  /// Simulates at most so many ticks. Compares the state with the recorded one about once per simulated second and at
  /// the end, as far as there are records. Fails at the first tick found to differ, and says what differs; the branch
  /// is useless afterwards.
  Result<void> Advance(std::uint64_t most_ticks);
  /// The tick that it has reached, and the tick that it goes to.
  std::uint64_t tick() const { return tick_; }
  std::uint64_t goal() const { return goal_; }
  bool IsThere() const { return tick_ == goal_ && is_checked_; }
  /// What may change the run: another build made the recording, or files of the scenario have changed (kept files are
  /// not affected).
  const std::vector<Diagnostic>& warnings() const { return warnings_; }

  /// The simulation, at the end of the tick. Call only when IsThere(), and only once.
  std::unique_ptr<sim::Simulation> TakeSimulation() { return std::move(simulation_); }
  /// The same to inspect, until it is taken.
  sim::Simulation& simulation() { return *simulation_; }

  /// Compares the future that the simulation now takes with the recorded one.
  class Futures CompareFutures() const;

 private:
  Branch(TickSource& past, Rerun rerun, std::uint64_t tick);
  static Result<std::unique_ptr<Branch>> Begin(TickSource& past, Result<Rerun> rerun, std::uint64_t tick);
  Result<void> Check();

  TickSource& past_;
  std::unique_ptr<sim::Simulation> simulation_;
  std::vector<Diagnostic> warnings_;
  Level level_;
  std::uint64_t tick_ = 0;
  std::uint64_t goal_;
  bool is_checked_ = false;
  Comparer comparer_;
};

/// The old future and the new one, side by side: A is the old, B the new.
class Futures {
 public:
  Futures(TickSource& old, Comparer comparer) : old_(old), comparer_(std::move(comparer)) {}

  /// Adds the new future's next tick. Ticks in order.
  void See(const TickRecord& now);
  /// The old future at a tick, for example where its bodies were; null if it is unknown. Valid until the next call.
  const TickRecord* Old(std::uint64_t tick);
  /// The first difference, the first decision or command that differs, what was perceived differently, and the course.
  const Comparison& comparison() const { return comparer_.result(); }

 private:
  TickSource& old_;
  Comparer comparer_;
};

}  // namespace soarbox::record
