// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent.h"

// From steering to motion: what nearly every script does with an agent in every step. The arithmetic is that of the
// scripts which did this in Lua: numbers are double, vectors single precision.
namespace soarbox::world {

/// Pushes with all of the agent's strength along the ground towards `force`, for the next step of that length, and
/// turns the agent towards where it will move. Does nothing to agents without mass. False if the force is not finite.
bool PushAlongGround(Agent& agent, Vec3 force, double step_s);

/// Changes the velocity instead, smoothly: `acceleration` remembers from step to step. Does nothing to agents without
/// mass, or for forces that are next to nothing. False if the force is not finite.
bool PushSmoothly(Agent& agent, Vec3 force, Vec3& acceleration, double step_s);

/// Lowers the horizontal speed to the agent's top speed; leaves jumps and falls alone.
void ClampHorizontalSpeed(Agent& agent);

/// How an agent that walks gives way to others and to things.
struct GivingWay {
  float look_ahead_s = 1.5f;
  float weight = 3;  ///< Beside the wish to get to the goal.
};
/// The force that takes the agent to a place, around agents and movable objects that are in the way.
Vec3 ForceToWalk(const Agent& agent, Vec3 goal, const GivingWay& giving_way);

}  // namespace soarbox::world
