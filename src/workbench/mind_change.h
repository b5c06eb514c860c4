// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "record/tick_record.h"
#include "sim/simulation.h"

namespace soarbox::workbench {

/// What a mind said last in a tick, or how that went; empty if it said nothing.
std::string LastCommand(const mind::EventLog& events);

/// Waits until an agent's operators, its goal stack or its command change.
class MindChange {
 public:
  /// From now on. Why it cannot be; empty: it can.
  std::string Await(sim::Simulation* live, const std::string& agent, std::uint64_t tick);
  void AwaitNothing() {
    before_ = {};
    change_.clear();
  }
  /// After each tick.
  void Look(sim::Simulation& live, const record::TickRecord& tick);
  /// What changed in the last tick, a sentence, once; or that nothing has for long.
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
