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

/// The past of a live run: shows any of its ticks, with the world and its minds as they were then, and lets the run go
/// on from there, with the old future kept for comparison. Or a recording, which has nothing but a past: there is
/// always a tick of it that is shown, and nothing goes on from it.
class TimeMachine {
 public:
  /// `header` tells which run it is; the same scenario and settings make it again.
  TimeMachine(const record::Header& header, sim::Scenario scenario, sim::SimulationSettings settings);

  /// The ticks of this range of a recording, which must live longer. Its scenario is looked for again below `data`.
  TimeMachine(record::TickSource& recording, const sim::DataFolders& data, std::uint64_t first, std::uint64_t last);
  TimeMachine(const TimeMachine&) = delete;
  TimeMachine& operator=(const TimeMachine&) = delete;

  /// The next tick of a live run.
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

  /// Shows a past tick from now on; of a live run, the last one: that of the run.
  void Seek(std::uint64_t tick);
  void GoLive();
  bool is_live() const { return !shown_.has_value(); }
  std::uint64_t shown_tick() const { return shown_.value_or(last_tick()); }
  /// What is recorded of the tick that is shown; null if it cannot be read. Valid until the next call.
  const record::TickRecord* Shown();

  /// The record of any tick; null if it cannot be read. Valid until the next call.
  const record::TickRecord* At(std::uint64_t tick);

  /// The world of the tick that is shown; while live, none.
  RebuiltWorld& rebuilt() { return rebuilt_; }
  const RebuiltWorld& rebuilt() const { return rebuilt_; }

  /// Hands over the world of the tick that is shown, for the run to go on with; null if it is not there. What came
  /// after it becomes the old future.
  std::unique_ptr<sim::Simulation> Resume();

  /// Where the run went back and on the last time.
  struct Parting {
    std::uint32_t number = 0;                ///< How often it did.
    std::uint64_t tick = 0;                  ///< The tick that it went back to.
    record::TickRecord record;               ///< What is recorded of that tick.
    std::vector<record::TickInputs> inputs;  ///< All that had come in by then.
    record::Futures futures;                 ///< The old future.
  };
  /// Null before the first Resume.
  Parting* parting() { return parting_ ? &*parting_ : nullptr; }
  /// What may make a rebuilt past differ from the recorded one; each once.
  std::vector<Diagnostic> TakeWarnings() { return std::exchange(warnings_, {}); }

 private:
  record::History& history() const { return *histories_.back(); }
  record::TickSource& timeline() const { return recording_ != nullptr ? *recording_ : history(); }

  record::TickSource* recording_ = nullptr;  ///< Null: a live run.
  std::uint64_t first_ = 0, last_ = 0;       ///< Of the recording.
  std::vector<Diagnostic> warnings_;
  bool has_warned_ = false;

  /// The last one is that of the run; each before it is the future that was left. They refer to each other.
  std::vector<std::unique_ptr<record::History>> histories_;
  std::optional<std::uint64_t> shown_;
  RebuiltWorld rebuilt_;
  std::optional<Parting> parting_;
};

}  // namespace soarbox::workbench
