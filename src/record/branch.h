// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "record/compare.h"
#include "record/rerun.h"
#include "record/tick_source.h"

namespace soarbox::record {

/// Goes back to a tick of a run and continues from there. A branch simulates the run again up to the tick, in slices so
/// that a window stays responsive. It then hands over a live simulation whose future may differ. The records of the old
/// future stay unchanged, for comparison.
///
///     Result<std::unique_ptr<Branch>> branch = Branch::Begin(history, scenario, settings, tick);
///     while (!(*branch)->IsThere()) if (const auto gone = (*branch)->Advance(20); !gone) ...;
///     simulation = (*branch)->TakeSimulation();      // then Submit edits, Tick, Inspect minds
///     Futures futures = (*branch)->CompareFutures(); // then See each new tick
///
/// The timeline must outlive the branch and everything created from it. It may grow meanwhile. Not thread-safe.
class Branch {
 public:
  /// For a running world, with its scenario and the settings that it was created with. Debuggers cannot attach to the
  /// branch.
  static Result<std::unique_ptr<Branch>> Begin(TickSource& past, const sim::Scenario& scenario,
                                               const sim::SimulationSettings& settings, std::uint64_t tick);
  /// For a recording, whose scenario is searched for again. `threads`: number of threads for minds; 0: one per core.
  static Result<std::unique_ptr<Branch>> Begin(TickSource& past, const sim::DataFolders& data, std::uint64_t tick,
                                               int threads = 0);

  /// Simulates at most `most_ticks` ticks. Compares the state with the recorded one about once per simulated second and
  /// at the end, as far as there are records. Fails at the first tick that differs, and says what differs; the branch
  /// cannot be used afterwards.
  Result<void> Advance(std::uint64_t most_ticks);
  /// The tick that it has reached.
  std::uint64_t tick() const { return tick_; }
  std::uint64_t goal() const { return goal_; }
  bool IsThere() const { return tick_ == goal_ && is_checked_; }
  /// Reasons why the run may differ: another build made the recording, or files of the scenario have changed (files
  /// that the recording keeps do not count).
  const std::vector<Diagnostic>& warnings() const { return warnings_; }

  /// Hands over the simulation, at the end of the tick. Call it only when IsThere(), and only once.
  std::unique_ptr<sim::Simulation> TakeSimulation() { return std::move(simulation_); }
  /// The simulation, to inspect it before TakeSimulation.
  sim::Simulation& simulation() { return *simulation_; }

  /// Compares the simulation's future from now on with the recorded one.
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

/// Compares the old future (A) with the new one (B).
class Futures {
 public:
  Futures(TickSource& old, Comparer comparer) : old_(old), comparer_(std::move(comparer)) {}

  /// Adds the next tick of the new future. Ticks come in order.
  void See(const TickRecord& now);
  /// The record of the old future at a tick, for example with the positions of its bodies; null if there is none. Valid
  /// until the next call.
  const TickRecord* Old(std::uint64_t tick);
  /// The first difference, the first decision or command that differs, the percepts that differ, and the distance over
  /// time.
  const Comparison& comparison() const { return comparer_.result(); }

 private:
  TickSource& old_;
  Comparer comparer_;
};

}  // namespace soarbox::record
