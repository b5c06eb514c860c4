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

/// Finds agents whose rules fire without end: the phase reaches max-elaborations in tick after tick. Such a run is
/// slow, and what it shows is not what the agent would do.
class EndlessRules {
 public:
  /// Call once for each tick, with its events. True as soon as an agent has reached the limit in kMostTicks ticks.
  bool See(const sim::EventList& events, sim::Simulation& simulation);
  /// What to report, once See has returned true: which rule, and what to do.
  const std::string& text() const { return text_; }

  /// One simulated second.
  static constexpr int kMostTicks = 30;

 private:
  struct Agent {
    std::string text;
    std::uint64_t elaborations = 0;
    int ticks = 0;
  };
  std::map<std::string, Agent> agents_;  ///< Those that have reached the limit once.
  std::string text_;
};

}  // namespace soarbox::mission
