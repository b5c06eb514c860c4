// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mission/check_keys.h"
#include "world/math.h"

namespace soarbox::mission {

/// An event of an agent in a tick.
struct EventFact {
  Key key = Key::kPrints;
  std::string word;                                       ///< Target, object, rule or command.
  std::vector<std::pair<std::string, std::string>> with;  ///< Parameters.
  std::string status, reason;  ///< For an answer to a command (empty: the command was given). For an impasse: the
                               ///< reason in words.
};

/// An operator that was selected in a tick.
struct OperatorFact {
  int level = 1;
  std::string name;
  std::vector<std::pair<std::string, std::string>> with;
  std::string_view selected_by;  ///< "only" candidate, "preference", "chance"; empty if it is not reported.
  std::string why;               ///< In words, if it is reported.
};

struct ElementFact {
  std::size_t path = 0;  ///< Index in Wants::elements.
  std::string value;
  char support = 'i';
};

/// The data of one agent at the end of a tick that checks can test. Numbers that no check needs are not updated.
struct AgentFacts {
  std::string name, team;
  bool alive = true;
  bool has_mind = false;
  world::Vec3 position;
  double health = 0, speed = 0;
  std::optional<double> ammunition, score;
  double distance = 0, rounds = 0, damage = 0, idle = 0, repeats = 0;
  double answered = 0, decisions = 0, firings = 0, elements = 0, depth = 1, learned = 0;
  double reused = 0, reward = 0, updates = 0, values = 0;
  std::vector<std::string> carried, sees;
  std::vector<EventFact> events;
  std::vector<OperatorFact> operators;
  std::vector<ElementFact> found;
};

struct ItemFacts {
  std::string name;
  world::Vec3 position;
  bool carried = false;
};

struct PlaceFacts {
  std::string name;
  world::Vec3 center;
  float radius_m = 0, half_x_m = 0, half_z_m = 0;  ///< As in sim::Region; 0 for a waypoint.
};

/// The data of one tick that checks can test.
struct TickFacts {
  std::uint64_t tick = 0;
  double time_s = 0;
  std::vector<AgentFacts> agents;  ///< In the order of creation. Agents are never removed; a destroyed agent is
                                   ///< reported as dead.
  std::vector<ItemFacts> items;
  std::vector<PlaceFacts> waypoints, regions;  ///< Constant during a run.
  std::vector<std::string> ended;              ///< Ends and goals that were reached so far.
  std::vector<EventFact> problems;
};

}  // namespace soarbox::mission
