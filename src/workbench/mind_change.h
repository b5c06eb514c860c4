// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "record/tick_record.h"
#include "sim/simulation.h"

namespace soarbox::workbench {

/// The last command that a mind gave in a tick, or its outcome; empty if it gave none.
std::string LastCommand(const mind::EventLog& events);

/// Waits until an agent's operators, its goal stack or its command change.
class MindChange {
 public:
  /// Begins to wait. Returns why it cannot; empty if it can.
  std::string Await(sim::Simulation* live, const std::string& agent, std::uint64_t tick);
  void AwaitNothing() {
    before_ = {};
    change_.clear();
  }
  /// After each tick.
  void Look(sim::Simulation& live, const record::TickRecord& tick);
  /// One sentence, told once: what changed in the last tick, or that nothing has changed for a long time.
  std::string Take();

 private:
  /// The mind as it was.
  struct Mind {
    std::string agent, operators, impasse;
    std::uint64_t tick = 0;
  };
  static Mind Now(sim::Simulation* live, const std::string& agent, std::uint64_t tick);

  Mind before_;  ///< No agent: none is awaited.
  std::string change_;
};

}  // namespace soarbox::workbench
