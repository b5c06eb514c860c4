// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "record/tick_record.h"
#include "sim/simulation.h"

namespace soarbox::workbench {

/// The last command that a mind gave in a tick, or its result; empty if there is none.
std::string LastCommand(const mind::EventLog& events);

/// Waits until an agent's selected operators or impasses change, or it gives a command; for at most 3,600 ticks.
/// Operator no-changes do not count as impasses: they are normal while a command takes time.
class MindChange {
 public:
  /// Starts to wait. Returns an error message, or an empty string.
  std::string Await(sim::Simulation* live, const std::string& agent, std::uint64_t tick);
  void AwaitNothing() {
    before_ = {};
    change_.clear();
  }
  /// Call it after each tick.
  void Look(sim::Simulation& live, const record::TickRecord& tick);
  /// Returns a sentence when the wait has ended: what changed, or that nothing has. Empty before that, and in later
  /// calls.
  std::string Take();

 private:
  /// The state of the mind at a tick.
  struct Mind {
    std::string agent, operators, impasse;
    std::uint64_t tick = 0;
  };
  static Mind Now(sim::Simulation* live, const std::string& agent, std::uint64_t tick);

  Mind before_;  ///< Its agent is empty if no change is awaited.
  std::string change_;
};

}  // namespace soarbox::workbench
