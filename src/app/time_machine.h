// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/branch.h"
#include "record/history.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::app {

/// The past of a live run: shows any of its ticks, rebuilds the world and its minds as they were then, and lets the run
/// go on from there, with the old future kept for comparison.
class TimeMachine {
 public:
  /// `header` tells which run it is; the same scenario and settings make it again.
  TimeMachine(const record::Header& header, sim::Scenario scenario, sim::SimulationSettings settings);

  /// The next tick of the run.
  void Add(const record::TickRecord& tick);

  std::uint64_t first_tick() const { return history().empty() ? 0 : history().first_tick(); }
  std::uint64_t last_tick() const { return history().empty() ? 0 : history().last_tick(); }
  bool empty() const { return history().empty(); }

  /// Shows a past tick from now on; the last one: that of the live run.
  void Seek(std::uint64_t tick);
  void GoLive();
  bool is_live() const { return !shown_.has_value(); }
  std::uint64_t shown_tick() const { return shown_.value_or(last_tick()); }
  /// What is recorded of the tick that is shown; null if it cannot be read. Valid until the next call.
  const record::TickRecord* Shown();

  /// Rebuilds the world of the tick that is shown, a slice of about this long at a time. Nothing to do while live.
  void Rebuild(double most_s);
  /// The rebuilt world; null while it is not there.
  sim::Simulation* past();
  /// Why not: how far it is, or what went wrong.
  std::string PastNote() const;

  /// Hands over the world of the tick that is shown, for the run to go on with; null if it is not there. What came
  /// after it becomes the old future.
  std::unique_ptr<sim::Simulation> Resume();

  /// The old future: null before the first Resume.
  record::Futures* futures() { return futures_ ? &*futures_ : nullptr; }
  std::optional<std::uint64_t> branch_tick() const { return branch_tick_; }
  /// How often the run went back and on.
  std::uint32_t branches() const { return static_cast<std::uint32_t>(histories_.size() - 1); }

 private:
  record::History& history() const { return *histories_.back(); }

  sim::Scenario scenario_;
  sim::SimulationSettings settings_;
  /// The last one is that of the run; each before it is the future that was left. They refer to each other.
  std::vector<std::unique_ptr<record::History>> histories_;
  std::optional<std::uint64_t> shown_;
  std::unique_ptr<record::Branch> branch_;
  std::string trouble_;
  std::optional<record::Futures> futures_;
  std::optional<std::uint64_t> branch_tick_;
};

}  // namespace soarbox::app
