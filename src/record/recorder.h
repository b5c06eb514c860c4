// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "record/tick_record.h"
#include "record/writer.h"
#include "sim/simulation.h"

namespace soarbox::record {

/// What a simulation tells of the tick that it has just finished, or of its set-up if it has made none. `events` are
/// those of the tick (Simulation::TakeEvents hands them out once).
void Observe(const sim::Simulation& simulation, const sim::EventList& events, Level level, TickRecord& record);

/// Puts each tick of a run into a file.
class Recorder {
 public:
  explicit Recorder(std::unique_ptr<Writer> writer, Level level) : writer_(std::move(writer)), level_(level) {}

  /// Call after the set-up and after each tick. A problem (a full disk) is told once; the run goes on without.
  Result<void> Take(const sim::Simulation& simulation, const sim::EventList& events);
  /// The same for a tick that is known already.
  Result<void> Take(const TickRecord& record);
  std::uint64_t bytes() const { return writer_->bytes(); }

 private:
  std::unique_ptr<Writer> writer_;
  Level level_;
  bool failed_ = false;
  TickRecord record_;
};

/// The detail that minds must be asked for (Simulation settings) so that a recording of this level is complete.
sim::MindDetail DetailOf(Level level);

}  // namespace soarbox::record
