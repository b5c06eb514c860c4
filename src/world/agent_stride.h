// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent.h"

// Conversion of steering forces to motion, which nearly every script does in every step. The arithmetic is that of the
// scripts that did this in Lua: scalars are double, vectors are single precision.
namespace soarbox::world {

/// Applies a force of MaxForce along the ground in the direction of `force`, for the next step of `step_s` seconds, and
/// turns the agent towards its motion. Does nothing if the agent has no mass. Returns false if the force is not finite.
bool PushAlongGround(Agent& agent, Vec3 force, double step_s);

/// Limits the horizontal speed to MaxSpeed. Does not change the vertical speed, so that jumps and falls are not
/// affected.
void ClampHorizontalSpeed(Agent& agent);

/// How a walking agent avoids others and things.
struct GivingWay {
  float look_ahead_s = 1.5f;
  float weight = 3;  ///< Relative to the force towards the goal.
};
/// The force that moves the agent to a position, around agents and movable objects in the way.
Vec3 ForceToWalk(const Agent& agent, Vec3 goal, const GivingWay& giving_way);

}  // namespace soarbox::world
