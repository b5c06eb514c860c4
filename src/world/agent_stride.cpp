// SPDX-License-Identifier: BSD-2-Clause
#include "world/agent_stride.h"

#include <cmath>

#include "world/rotation.h"

namespace soarbox::world {
namespace {

constexpr double kWeakest = 0.1;  // Square of the length below which a steering direction is ignored.
constexpr double kBlend = 0.4;    // The share of a new acceleration in the smoothed one.
constexpr double kTurn = 0.2;     // Fraction of the rotation to a new heading that is made in one step.

float Blend(float value, float change) {
  return static_cast<float>(static_cast<double>(value) + static_cast<double>(change) * kBlend);
}

}  // namespace

bool PushAlongGround(Agent& agent, Vec3 force, double step_s) {
  if (agent.Mass() <= 0) return true;
  force.y = 0;
  const Vec3 strength = Normalized(force) * agent.MaxForce();
  const Vec3 next = agent.Velocity() + strength * static_cast<float>(step_s / static_cast<double>(agent.Mass()));
  const bool is_accepted = agent.ApplyForce(strength);
  agent.SetForward({next.x, 0, next.z});
  return is_accepted || !agent.HasBody();
}

bool PushSmoothly(Agent& agent, Vec3 force, Vec3& acceleration, double step_s) {
  if (agent.Mass() <= 0 || static_cast<double>(LengthSquared(force)) < kWeakest) return true;
  force.y = 0;
  if (!(LengthSquared(force) > 0)) return IsFinite(force);
  const double strength = static_cast<double>(agent.MaxForce()) / static_cast<double>(agent.Mass());
  const Vec3 change = Normalized(force) * static_cast<float>(strength) - acceleration;
  acceleration = {Blend(acceleration.x, change.x), Blend(acceleration.y, change.y), Blend(acceleration.z, change.z)};
  const bool is_accepted = agent.SetVelocity(agent.Velocity() + acceleration * static_cast<float>(step_s));
  const Vec3 velocity = agent.Velocity();
  if (static_cast<double>(LengthSquared(velocity)) > kWeakest) {
    const Vec3 heading = Normalized(Vec3{velocity.x, 0, velocity.z});
    agent.SetForward(agent.Forward() * static_cast<float>(1 - kTurn) + heading * static_cast<float>(kTurn));
  }
  return is_accepted;
}

void ClampHorizontalSpeed(Agent& agent) {
  const Vec3 velocity = agent.Velocity();
  const double x = static_cast<double>(velocity.x), z = static_cast<double>(velocity.z);
  const double speed = std::sqrt(x * x + z * z), most = static_cast<double>(agent.MaxSpeed());
  if (!(speed > most)) return;
  const double factor = most / speed;
  agent.SetVelocity({static_cast<float>(x * factor), velocity.y, static_cast<float>(z * factor)});
}

Vec3 ForceToWalk(const Agent& agent, Vec3 goal, const GivingWay& giving_way) {
  return agent.ForceToPosition(goal) + agent.ForceToAvoidAgents(giving_way.look_ahead_s) * giving_way.weight +
         agent.ForceToAvoidObjects(giving_way.look_ahead_s) * giving_way.weight;
}

}  // namespace soarbox::world
