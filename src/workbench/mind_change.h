// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "record/tick_record.h"
#include "sim/simulation.h"

namespace soarbox::workbench {

/// The last command that a mind gave in a tick, or its result; empty if there is none.
std::string LastCommand(const mind::EventLog& events);

/// Waits until an agent's operators, goal stack or command change.
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
  /// Returns one sentence: what changed in the last tick, or that nothing has changed for a long time. Each sentence is
  /// returned once.
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
