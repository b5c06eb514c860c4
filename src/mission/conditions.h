// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "mission/facts.h"
#include "mission/mission.h"

namespace soarbox::mission {

/// How one condition stands in one tick.
struct Finding {
  bool holds = false;
  double times = 0;    ///< Of an event: how often it happened.
  double value = 0;    ///< Of a gauge or a counter.
  double away = 1e30;  ///< How far from holding: metres, or a gauge's difference.
  std::string detail;  ///< What was there: "it collided with bert", "health was 24". Empty: nothing to say.
};

/// Looks at a condition for one agent, one item or, with neither, the world.
Finding LookAt(const Condition& condition, const AgentFacts* agent, const ItemFacts* item, const TickFacts& facts,
               const Wants& wants);

/// Whether a text matches a pattern in which * stands for any text.
bool MatchesPattern(std::string_view pattern, std::string_view text);

}  // namespace soarbox::mission
