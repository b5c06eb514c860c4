// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "mission/event_facts.h"
#include "mission/mission.h"

namespace soarbox::mission {

/// The state of one condition in one tick.
struct Finding {
  bool holds = false;
  double times = 0;    ///< For an event: how often it occurred.
  double value = 0;    ///< For a gauge or a counter.
  double away = 1e30;  ///< Distance from being true: metres, or the difference of a gauge.
  std::string detail;  ///< What was found: "it collided with bert", "health was 24". Empty if there is nothing to
                       ///< report.
};

/// Evaluates a condition for one agent or one item; if both are null, for the world.
Finding LookAt(const Condition& condition, const AgentFacts* agent, const ItemFacts* item, const TickFacts& facts,
               const Wants& wants);

/// Whether a text matches a pattern in which * matches any text.
bool MatchesPattern(std::string_view pattern, std::string_view text);

}  // namespace soarbox::mission
