// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "record/branch.h"
#include "record/history.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::workbench {

/// The past of a live run: shows any of its ticks, rebuilds the world and its minds as they were then, and lets the run
/// go on from there, with the old future kept for comparison. Or a recording, which has nothing but a past: there is
/// always a tick of it that is shown, and nothing goes on from it.
class TimeMachine {
 public:
  /// `header` tells which run it is; the same scenario and settings make it again.
  TimeMachine(const record::Header& header, sim::Scenario scenario, sim::SimulationSettings settings);

  /// The ticks of this range of a recording, which must live longer. Its scenario is looked for again below `data`.
  TimeMachine(record::TickSource& recording, const sim::DataFolders& data, std::uint64_t first, std::uint64_t last);

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

  /// Rebuilds the world of the tick that is shown, a slice of about this long at a time. Nothing to do while live.
  void Rebuild(double most_s);
  /// The rebuilt world; null while it is not there.
  sim::Simulation* past();
  /// Why not: how far it is, or what went wrong.
  std::string PastNote() const;
  /// False if something went wrong: it will not be there.
  bool CanBeRebuilt() const { return trouble_.empty(); }

  /// Somebody has changed the rebuilt world: it is made anew for the next tick that is shown.
  void Spoil() { is_spoilt_ = true; }

  /// Hands over the world of the tick that is shown, for the run to go on with; null if it is not there. What came
  /// after it becomes the old future.
  std::unique_ptr<sim::Simulation> Resume();

  /// The old future: null before the first Resume.
  record::Futures* futures() { return futures_ ? &*futures_ : nullptr; }
  std::optional<std::uint64_t> branch_tick() const { return branch_tick_; }
  /// What is recorded of that tick; nothing before the first Resume.
  const record::TickRecord& branch_record() const { return branch_record_; }
  /// All that has come in since the run began.
  std::vector<record::TickInputs> Inputs() const;
  /// How often the run went back and on.
  std::uint32_t branches() const { return histories_.empty() ? 0 : static_cast<std::uint32_t>(histories_.size() - 1); }
  /// What may make a rebuilt past differ from the recorded one; each once.
  std::vector<Diagnostic> TakeWarnings() { return std::exchange(warnings_, {}); }

 private:
  record::History& history() const { return *histories_.back(); }
  Result<std::unique_ptr<record::Branch>> Begin();

  record::TickSource* recording_ = nullptr;  ///< Null: a live run.
  sim::DataFolders data_;
  std::uint64_t first_ = 0, last_ = 0;  ///< Of the recording.
  std::vector<Diagnostic> warnings_;
  bool has_warned_ = false, is_spoilt_ = false;

  sim::Scenario scenario_;
  sim::SimulationSettings settings_;
  /// The last one is that of the run; each before it is the future that was left. They refer to each other.
  std::vector<std::unique_ptr<record::History>> histories_;
  std::optional<std::uint64_t> shown_;
  std::unique_ptr<record::Branch> branch_;
  std::string trouble_;
  std::optional<record::Futures> futures_;
  std::optional<std::uint64_t> branch_tick_;
  record::TickRecord branch_record_;
};

}  // namespace soarbox::workbench
