// SPDX-License-Identifier: BSD-2-Clause
#include "sim/body_kind.h"

#include <algorithm>

namespace soarbox::sim {

std::span<const BodyKind> BodyKinds() {
  static const std::vector<BodyKind> kinds = [] {
    std::vector<BodyKind> made(4);
    BodyKind& walker = made[0];
    walker.name = "walker";
    walker.meaning = "a person without a weapon";

    BodyKind& soldier = made[1];
    soldier.name = "soldier";
    soldier.meaning = "a person with a rifle";
    soldier.armed = true;

    BodyKind& runner = made[2];
    runner.name = "runner";
    runner.meaning = "a person without a weapon who is fast";
    runner.max_speed_mps = 8;
    runner.walk_mps = 5;

    BodyKind& sentry = made[3];
    sentry.name = "sentry";
    sentry.meaning = "a slow person with a weapon that reaches far, and good eyes";
    sentry.armed = true;
    sentry.max_speed_mps = 2;
    sentry.walk_mps = 1.5f;
    sentry.weapon.range_m = 80;
    sentry.weapon.spread_deg = 0.7f;
    sentry.senses.sight_m = 80;
    return made;
  }();
  return kinds;
}

const AgentKind* FindAgentKind(std::string_view name) {
  static constexpr AgentKind kKinds[] = {
      {"seeking", "seekingagent.soar"},
      {"follower", "followeragent.soar", true},
      {"waypoint", "waypointagent.soar"},
      {"soar", "", false, true, true},
  };
  const auto at =
      std::find_if(std::begin(kKinds), std::end(kKinds), [&](const AgentKind& k) { return k.name == name; });
  return at == std::end(kKinds) ? nullptr : at;
}

}  // namespace soarbox::sim
