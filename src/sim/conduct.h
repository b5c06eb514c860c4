// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string_view>

#include "sim/actor.h"

namespace soarbox::sim {

/// The implementation of a command. `step` is called once per tick until the command is complete or has failed.
using ConductStep = StepResult (*)(Actor& actor, Running& command);

struct Conduct {
  std::string_view command;
  ConductStep step;
};

/// The implementations of all commands of the vocabulary.
std::span<const Conduct> MovingConducts();     // command_move.cpp
std::span<const Conduct> FollowingConducts();  // command_follow.cpp
std::span<const Conduct> FightingConducts();   // command_fight.cpp
std::span<const Conduct> CarryingConducts();   // command_carry.cpp
std::span<const Conduct> OtherConducts();      // command_other.cpp
/// The step of a command of the vocabulary. Null for other words.
ConductStep FindConduct(std::string_view command);
/// Whether a command only makes an agent walk: one of MovingConducts().
bool IsWalk(std::string_view command);
/// For `wander` only: computes in advance the direction that its next step will find if nothing else moves until then.
void ForeseeWander(Actor& actor, Running& command);

/// Walks towards a point around obstacles. With `slow_down`, it slows down near the point. Fails with "no-way" as soon
/// as the navigation mesh shows that there is no path. Fails with "blocked" after 4 s without progress if it hardly
/// moves, and after 24 s otherwise.
struct WalkOrder {
  world::Vec3 goal;
  float within_m = 0.75f;
  float speed_mps = 3;
  bool slow_down = true;
  bool stands = true;                          ///< Complete only after the body has stopped.
  world::EntityId through = world::kNoEntity;  ///< A thing or agent that is not an obstacle.
  world::EntityId shun = world::kNoEntity;     ///< An agent to avoid.
  float shun_m = 0;                            ///< Minimum distance to that agent.
};
StepResult WalkTo(Actor& actor, Running& command, const WalkOrder& order);
/// The direction closest to `wanted` (horizontal, of length 1 or 0) in which the next `ahead_m` metres are free. If
/// there is none, one in which less is free; else `wanted`. `turn_deg` stores the side on which it passes an obstacle,
/// so that the direction does not oscillate.
world::Vec3 FreeDirection(const Actor& actor, world::Vec3 wanted, float ahead_m, world::EntityId through,
                          float& turn_deg);

}  // namespace soarbox::sim
