// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "world/weapon.h"

namespace soarbox::sim {

/// How well an agent perceives, and what. Authors set these where they make the agent.
struct SenseSettings {
  float sight_m = 40;    ///< How far it sees.
  float view_deg = 200;  ///< Field of view from side to side; 360 includes what is behind it.
  float hearing_m = 15;  ///< How far it hears somebody who runs; half as far if they walk. Shots carry farther.
  float memory_s = 15;   ///< How long it remembers an agent that is no longer noticed.
  float noise_m = 0;     ///< Standard deviation of perceived positions of others, from the agent's own stream.
  float rate_hz = 10;    ///< How often senses are read. Its own body is read in each tick.
  float most = 0;        ///< At most this many friends and this many enemies, the nearest; 0: all it notices.
  bool scene = false;    ///< Its imagination (the spatial visual system) receives what it perceives.
  std::set<std::string> only = {};  ///< Names of senses; empty: all.

  bool Has(std::string_view sense) const { return only.empty() || only.contains(std::string(sense)); }
};

/// What an agent of the vocabulary is made of. Kinds are data: scenario files add their own.
struct BodyKind {
  std::string name;
  std::string meaning;  ///< For `soarbox list` and the reference.
  float height_m = 1.7f;
  float radius_m = 0.35f;
  float mass_kg = 80;
  float max_speed_mps = 5;
  float walk_mps = 3;  ///< Until set-speed says otherwise.
  float max_force_n = 1200;
  float health = 100;
  bool armed = false;
  world::WeaponSettings weapon;
  std::string looks = "person";      ///< Or another of kLooks.
  std::string material = "Ground2";  ///< Of a capsule.
  SenseSettings senses;
};

/// What an agent can look like.
inline constexpr std::string_view kLooks[] = {"person", "capsule",  "sheep", "bear", "hare", "cook",
                                              "wolf",   "villager", "robot", "cart", "bee",  "bell"};
/// The material that stands for a creature; empty: it looks like a person or a plain capsule.
std::string_view MaterialOfLooks(std::string_view looks);
/// The material of a thing or an item whose author names none, by the words of its name and by what it gives.
std::string_view MaterialOfThing(std::string_view name, std::string_view gives, bool is_item);

/// The kinds that come with the program; an author who names none gets the first one.
std::span<const BodyKind> BodyKinds();

/// An agent kind of the sandbox's Create functions, by the word in the scripts' requests.
struct AgentKind {
  std::string_view name;
  std::string_view rules;       ///< Its own rules if none are named; empty: some must be.
  bool follows_leader = false;  ///< ^distance is measured to its leader; without one it perceives nothing.
  bool blinks = true;           ///< ^distance counts as new in each tick, as in the thesis.
  bool waits = false;           ///< Its mind waits where nothing is proposed.
};
/// Null for a kind without a mind.
const AgentKind* FindAgentKind(std::string_view name);

}  // namespace soarbox::sim
