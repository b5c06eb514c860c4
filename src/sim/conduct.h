// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string_view>

#include "sim/actor.h"

namespace soarbox::sim {

/// One step of a command: called once per tick until it is done or has failed.
using ConductStep = StepResult (*)(Actor& actor, Running& command);

struct Conduct {
  std::string_view command;
  ConductStep step;
};

/// How bodies carry out the commands of the vocabulary; one for each row.
std::span<const Conduct> MovingConducts();     // command_move.cpp
std::span<const Conduct> FollowingConducts();  // command_follow.cpp
std::span<const Conduct> FightingConducts();   // command_fight.cpp
std::span<const Conduct> CarryingConducts();   // command_carry.cpp
std::span<const Conduct> OtherConducts();      // command_other.cpp
/// Null for a command that has none.
ConductStep FindConduct(std::string_view command);
/// Whether a command moves legs and neck at most.
bool IsWalk(std::string_view command);
/// For `wander` only: finds the way that its next step will take if nothing else moves until then.
void ForeseeWander(Actor& actor, Running& command);

/// Walks towards a point, round what is in the way. `slow_down`: comes to rest on it. Fails with "no-way" as soon as
/// the ways show that there is none, and with "blocked" after 4 s without progress. For the conducts.
struct WalkOrder {
  world::Vec3 goal;
  float within_m = 0.75f;
  float speed_mps = 3;
  bool slow_down = true;
  bool stands = true;                          ///< Done only once it has come to rest.
  world::EntityId through = world::kNoEntity;  ///< A thing or agent that is no obstacle.
  world::EntityId shun = world::kNoEntity;     ///< An agent to avoid on the way,
  float shun_m = 0;                            ///< and how far to stay away from it.
};
StepResult WalkTo(Actor& actor, Running& command, const WalkOrder& order);
/// The direction nearest to the wanted one (level, of length 1 or 0) in which the next metres are free; remembers the
/// side in `turn_deg`, so that it does not dither.
world::Vec3 FreeDirection(const Actor& actor, world::Vec3 wanted, float ahead_m, world::EntityId through,
                          float& turn_deg);

}  // namespace soarbox::sim
