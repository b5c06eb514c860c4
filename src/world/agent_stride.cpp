// SPDX-License-Identifier: BSD-2-Clause
#include "world/agent_stride.h"

#include <cmath>

#include "world/rotation.h"

namespace soarbox::world {

bool PushAlongGround(Agent& agent, Vec3 force, double step_s) {
  if (agent.Mass() <= 0) return true;
  force.y = 0;
  const Vec3 strength = Normalized(force) * agent.MaxForce();
  const Vec3 next = agent.Velocity() + strength * static_cast<float>(step_s / static_cast<double>(agent.Mass()));
  const bool is_accepted = agent.ApplyForce(strength);
  agent.SetForward({next.x, 0, next.z});
  return is_accepted || !agent.HasBody();
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
