// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "world/weapon.h"

namespace soarbox::sim {

/// How well and what an agent perceives. Authors set this where the agent is created.
struct SenseSettings {
  float sight_m = 40;    ///< Range of sight.
  float view_deg = 200;  ///< Field of view from side to side; 360 includes the back.
  float hearing_m = 15;  ///< Distance at which it hears running agents. It hears walking agents at half this distance,
                         ///< and shots farther.
  float memory_s = 15;   ///< Time for which it remembers an agent that it no longer perceives.
  float noise_m = 0;     ///< Standard deviation of perceived positions of others. Random numbers come from the agent's
                         ///< own stream.
  float rate_hz = 10;    ///< Frequency at which the surroundings are read. The own body is read in each tick.
  float most = 0;        ///< Maximum number of friends, and of enemies, that it perceives; the nearest ones. 0: no
                         ///< limit.
  bool scene = false;    ///< Its spatial visual system receives what it perceives.
  std::set<std::string> only = {};  ///< Names of the senses that it has; empty: all.

  bool Has(std::string_view sense) const { return only.empty() || only.contains(std::string(sense)); }
};

/// The properties of a body. Scenario files can add kinds of bodies.
struct BodyKind {
  std::string name;
  std::string meaning;  ///< For `soarbox list` and the reference.
  float height_m = 1.7f;
  float radius_m = 0.35f;
  float mass_kg = 80;
  float max_speed_mps = 5;
  float walk_mps = 3;  ///< Walking speed, unless the command set-speed changes it.
  float max_force_n = 1200;
  float health = 100;
  bool armed = false;
  world::WeaponSettings weapon;
  std::string looks = "person";      ///< One of kLooks.
  std::string material = "Ground2";  ///< Material of a capsule.
  SenseSettings senses;
};

/// Possible appearances of an agent.
inline constexpr std::string_view kLooks[] = {"person", "capsule",  "sheep", "bear", "hare", "cook",
                                              "wolf",   "villager", "robot", "cart", "bee",  "bell"};
/// The material of the figure; empty for a person or a plain capsule.
std::string_view MaterialOfLooks(std::string_view looks);
/// The default material of a thing or an item, chosen by the words of its name and by what it gives.
std::string_view MaterialOfThing(std::string_view name, std::string_view gives, bool is_item);

/// The kinds that come with the program. The first one is the default.
std::span<const BodyKind> BodyKinds();

/// A kind of agent of the sandbox's Create functions, by its word in requests of scripts.
struct AgentKind {
  std::string_view name;
  std::string_view rules;       ///< The default rules; empty: the author must name rules.
  bool follows_leader = false;  ///< ^distance is the distance to its leader. Without a leader it perceives nothing.
  bool blinks = true;           ///< ^distance is a new element in each tick, as in the thesis.
  bool waits = false;           ///< Its mind waits when no operator is proposed (soar wait-snc).
};
/// Null for a kind without a mind.
const AgentKind* FindAgentKind(std::string_view name);

}  // namespace soarbox::sim
