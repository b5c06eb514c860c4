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

/// Records the tick that a simulation has just finished, or its set-up if it has made none. `events` are those of the
/// tick (Simulation::TakeEvents returns them only once).
void Observe(const sim::Simulation& simulation, sim::EventList events, Level level, TickRecord& record);

/// Leaves out what a recording of this level does not hold.
void KeepLevel(TickRecord& record, Level level);

/// Writes each tick of a run to a file. The run's thread only notes the tick; another thread writes it. If no thread
/// can be started, the run's thread writes it.
class Recorder {
 public:
  Recorder(std::unique_ptr<Writer> writer, Level level);
  /// Writes what is waiting.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Call after the set-up and after each tick. A problem (a full disk) is reported once, perhaps a little later; the
  /// run continues without a recording. `seen`: what a caller has already observed of this tick; it is then not
  /// observed again.
  Result<void> Take(const sim::Simulation& simulation, sim::EventList events, const TickRecord* seen = nullptr);
  /// The same for a tick whose record exists.
  Result<void> Take(TickRecord record);
  /// Ends the recording. The file is then complete, or a problem that was not yet reported is returned. Add nothing
  /// after this.
  Result<void> Finish();

 private:
  void Write();
  void Write(TickRecord& tick);
  void Flush();
  TickRecord Blank();
  Result<void> Push(TickRecord tick);

  std::unique_ptr<Writer> writer_;  ///< The writing thread's.
  Level level_;
  bool is_told_ = false;  ///< The failure has been reported.

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<TickRecord> waiting_;   ///< For the writing thread.
  std::vector<TickRecord> written_;  ///< Written records, whose memory is used again.
  bool is_over_ = false;             ///< Nothing more comes.
  std::optional<Diagnostic> failure_;
  std::thread thread_;  ///< Not joinable: the run's thread writes.
};

/// The detail to ask of minds (Simulation settings) for a complete recording of this level.
sim::MindDetail DetailOf(Level level);

}  // namespace soarbox::record
