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

/// What a simulation tells of the tick that it has just finished, or of its set-up if it has made none. `events` are
/// those of the tick (Simulation::TakeEvents hands them out once).
void Observe(const sim::Simulation& simulation, sim::EventList events, Level level, TickRecord& record);

/// Leaves out what a recording of this level does not hold.
void KeepLevel(TickRecord& record, Level level);

/// Puts each tick of a run into a file. The run's thread only notes what there is; a thread of its own writes it down.
class Recorder {
 public:
  Recorder(std::unique_ptr<Writer> writer, Level level);
  /// Writes what there is.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Call after the set-up and after each tick. A problem (a full disk) is told once, a little later perhaps; the run
  /// goes on without. `seen`: what somebody has observed of this very tick, if anybody has; it is not looked at again.
  Result<void> Take(const sim::Simulation& simulation, sim::EventList events, const TickRecord* seen = nullptr);
  /// The same for a tick that is known already.
  Result<void> Take(TickRecord record);
  /// Ends the recording: all is in the file then, or the problem is told if it was not yet. Nothing may follow.
  Result<void> Finish();

 private:
  void Write();
  TickRecord Blank();
  Result<void> Push(TickRecord tick);

  std::unique_ptr<Writer> writer_;  ///< The writing thread's.
  Level level_;
  bool is_told_ = false;  ///< The failure has been.

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<TickRecord> waiting_;   ///< For the writing thread.
  std::vector<TickRecord> written_;  ///< Their memory is used again.
  bool is_over_ = false;             ///< Nothing more comes.
  std::optional<Diagnostic> failure_;
  std::thread thread_;
};

/// The detail that minds must be asked for (Simulation settings) so that a recording of this level is complete.
sim::MindDetail DetailOf(Level level);

}  // namespace soarbox::record
