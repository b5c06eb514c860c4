// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "record/tick_record.h"
#include "record/writer.h"
#include "sim/simulation.h"

namespace soarbox::record {

/// Fills `record` with the tick that a simulation has just finished, or with its set-up before the first tick. `events`
/// are those of the tick, because Simulation::TakeEvents returns them only once.
void Observe(const sim::Simulation& simulation, sim::EventList events, Level level, TickRecord& record);

/// Removes data that a recording of this level does not contain.
void KeepLevel(TickRecord& record, Level level);

/// Writes each tick of a run to a file. The thread of the run only copies the tick; another thread writes it. If no
/// thread can be started, the thread of the run writes it.
///
/// There are at most `records` records, whose memory is reused. If all of them wait to be written, the run waits, too.
/// The recording then reports at its end how often and how long (Waits in file_format.h).
class Recorder {
 public:
  static constexpr std::size_t kRecords = 64;  ///< A little over two seconds of simulated time.

  Recorder(std::unique_ptr<Writer> writer, Level level, std::size_t records = kRecords);
  /// Writes the remaining ticks.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Call it after the set-up and after each tick. A problem, such as a full disk, is returned once, perhaps some ticks
  /// later; the run then continues without a recording. `seen`: a record of this tick, if the caller has already called
  /// Observe.
  Result<void> Take(const sim::Simulation& simulation, sim::EventList events, const TickRecord* seen = nullptr);
  /// Records a tick that the caller has observed.
  Result<void> Take(TickRecord record);
  /// Ends the recording. Returns a problem that was not yet returned. Do not call Take afterwards.
  Result<void> Finish();

 private:
  void Write();
  void Write(TickRecord& tick);
  void Flush();
  TickRecord& Blank();
  Result<void> Push();

  std::unique_ptr<Writer> writer_;  ///< Used only by the writing thread.
  Level level_;
  bool is_told_ = false;  ///< The failure was returned to the caller.

  std::mutex mutex_;
  std::condition_variable has_work_, has_room_;
  std::deque<TickRecord> waiting_;   ///< Ticks that are to be written.
  std::vector<TickRecord> written_;  ///< Records that were written, to be used again.
  std::optional<TickRecord> blank_;  ///< The record that the run fills in. If that throws, the next tick uses it.
  std::size_t unused_;               ///< Number of records that were not created yet.
  bool is_waited_for_ = false;       ///< The run waits for a record.
  bool is_over_ = false;             ///< No more ticks will be added.
  Waits waits_;
  std::optional<Diagnostic> failure_;
  std::thread thread_;  ///< Not joinable if the thread of the run writes.
};

/// The detail that minds must record for a recording of this level (SimulationSettings).
sim::MindDetail DetailOf(Level level);

}  // namespace soarbox::record
