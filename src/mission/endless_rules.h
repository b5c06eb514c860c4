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

/// Finds agents whose rules fire endlessly: the phase reaches max-elaborations in many ticks. Such a run is slow and
/// does not show what the agent would do.
class EndlessRules {
 public:
  /// Call it once for each tick, with its events. Returns true when an agent has reached the limit in kMostTicks ticks.
  bool See(const sim::EventList& events, sim::Simulation& simulation);
  /// The report after See has returned true: which rule, and what to do.
  const std::string& text() const { return text_; }

  /// One simulated second.
  static constexpr int kMostTicks = 30;

 private:
  struct Agent {
    std::string text;
    std::uint64_t elaborations = 0;
    int ticks = 0;
  };
  std::map<std::string, Agent> agents_;  ///< Agents that have reached the limit at least once.
  std::string text_;
};

}  // namespace soarbox::mission
