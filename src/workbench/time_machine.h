// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "record/branch.h"
#include "record/history.h"
#include "sim/scenario.h"
#include "sim/simulation.h"
#include "workbench/rebuilt_world.h"

namespace soarbox::workbench {

/// The past of a live run. It shows any of its ticks, with the world and its minds at that time, and can continue the
/// run from there; the old future is kept for comparison. For a recording, all ticks are past: one of them is always
/// shown, and the run cannot continue.
class TimeMachine {
 public:
  /// `header` describes the run. The same scenario and settings create it again.
  TimeMachine(const record::Header& header, sim::Scenario scenario, sim::SimulationSettings settings);

  /// The ticks of this range of a recording, which must outlive this object. Its scenario is searched for below `data`.
  TimeMachine(record::TickSource& recording, const sim::DataFolders& data, std::uint64_t first, std::uint64_t last);
  TimeMachine(const TimeMachine&) = delete;
  TimeMachine& operator=(const TimeMachine&) = delete;

  /// Adds the next tick of a live run.
  void Add(const record::TickRecord& tick);

  bool is_recording() const { return recording_ != nullptr; }
  std::uint64_t first_tick() const {
    if (recording_ != nullptr) return first_;
    return history().empty() ? 0 : history().first_tick();
  }
  std::uint64_t last_tick() const {
    if (recording_ != nullptr) return last_;
    return history().empty() ? 0 : history().last_tick();
  }
  bool empty() const { return recording_ == nullptr && history().empty(); }

  /// Shows a past tick. For a live run, the last tick means GoLive.
  void Seek(std::uint64_t tick);
  void GoLive();
  bool is_live() const { return !shown_.has_value(); }
  std::uint64_t shown_tick() const { return shown_.value_or(last_tick()); }
  /// The record of the tick that is shown; null if it cannot be read. Valid until the next call.
  const record::TickRecord* Shown();

  /// The record of any tick; null if it cannot be read. Valid until the next call.
  const record::TickRecord* At(std::uint64_t tick);

  /// The rebuilt world of the tick that is shown. Has no world while the newest tick of a live run is shown.
  RebuiltWorld& rebuilt() { return rebuilt_; }
  const RebuiltWorld& rebuilt() const { return rebuilt_; }

  /// Hands over the simulation of the tick that is shown, to continue the run from it; null if it is not available. The
  /// later ticks become the old future.
  std::unique_ptr<sim::Simulation> Resume();

  /// The last time that the run went back and continued.
  struct Parting {
    std::uint32_t number = 0;                ///< How often the run has done so.
    std::uint64_t tick = 0;                  ///< The tick from which it continued.
    record::TickRecord record;               ///< What is recorded of that tick.
    std::vector<record::TickInputs> inputs;  ///< All inputs up to that tick.
    record::Futures futures;                 ///< The old future.
  };
  /// Null before the first Resume.
  Parting* parting() { return parting_ ? &*parting_ : nullptr; }
  /// Possible reasons why the rebuilt past differs from the recorded one. Each is returned once.
  std::vector<Diagnostic> TakeWarnings() { return std::exchange(warnings_, {}); }

 private:
  record::History& history() const { return *histories_.back(); }
  record::TickSource& timeline() const { return recording_ != nullptr ? *recording_ : history(); }

  record::TickSource* recording_ = nullptr;  ///< Null for a live run.
  std::uint64_t first_ = 0, last_ = 0;       ///< The range of the recording.
  std::vector<Diagnostic> warnings_;
  bool has_warned_ = false;

  /// The last one is the history of the run; each earlier one is a future that the run left. Comparisons refer to them.
  std::vector<std::unique_ptr<record::History>> histories_;
  std::optional<std::uint64_t> shown_;
  RebuiltWorld rebuilt_;
  std::optional<Parting> parting_;
};

}  // namespace soarbox::workbench
