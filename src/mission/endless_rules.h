// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "sim/run_event.h"

namespace soarbox::sim {
class Simulation;
}

namespace soarbox::mission {

/// Finds agents whose rules fire endlessly: they are reported for it, and then need many elaborations in each of many
/// ticks, or were halted for it. Such a run is slow and does not show what the agent would do.
class EndlessRules {
 public:
  /// Call it once for each tick, with its events. Returns true when an agent has needed 50 elaborations in kMostTicks
  /// ticks, or was halted.
  bool See(const sim::EventList& events, sim::Simulation& simulation);
  /// The report after See has returned true: which rule, and what to do.
  const std::string& text() const { return text_; }

  /// One simulated second at 30 ticks per second.
  static constexpr int kMostTicks = 30;

 private:
  struct Agent {
    std::string text;
    std::uint64_t elaborations = 0;
    int ticks = 0;
  };
  std::map<std::string, Agent> agents_;  ///< Agents that the run has reported for firing endlessly.
  std::string text_;
};

}  // namespace soarbox::mission
