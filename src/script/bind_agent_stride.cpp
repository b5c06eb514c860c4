// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/api_call.h"
#include "world/agent_stride.h"

// Agent: from steering to motion. Scripts call these functions for each agent in each step, so they are not written in
// Lua.

namespace soarbox::script {
namespace {

using world::Agent;
using world::Vec3;
using enum WrongCount;

/// Pushes the agent along the ground for this step, up to its maximum speed.
void Stride(lua_State* state, Agent& agent, Vec3 force, double step_s) {
  WarnUnless(state, PushAlongGround(agent, force, step_s));
  ClampHorizontalSpeed(agent);
}

/// Also makes the caller's force horizontal, if the agent can be pushed.
void Push(lua_State* state, Agent& agent, Vec3 force, double step_s) {
  if (agent.Mass() > 0) ToVector(state, 2)->y = 0;
  WarnUnless(state, PushAlongGround(agent, force, step_s));
}

world::GivingWay GivingWayOf(std::optional<float> look_ahead_s, std::optional<float> weight) {
  world::GivingWay giving_way;
  giving_way.look_ahead_s = look_ahead_s.value_or(giving_way.look_ahead_s);
  giving_way.weight = weight.value_or(giving_way.weight);
  return giving_way;
}

void WalkTo(lua_State* state, Agent& agent, Vec3 goal, double step_s, std::optional<float> look_ahead_s,
            std::optional<float> weight) {
  Stride(state, agent, ForceToWalk(agent, goal, GivingWayOf(look_ahead_s, weight)), step_s);
}

void WalkToTarget(lua_State* state, Agent& agent, double step_s, std::optional<float> look_ahead_s,
                  std::optional<float> weight) {
  WalkTo(state, agent, agent.Target(), step_s, look_ahead_s, weight);
}

constexpr ApiFunction kAgentStrideFunctions[] = {
    {"Agent.ClampSpeed", kCall<world::ClampHorizontalSpeed>, kError, "agent: Agent", "",
     "Limits the horizontal speed to the agent's top speed. Jumps and falls are not affected.",
     R"(agent:SetVelocity(Vector.new(30, 0, 40))
agent:ClampSpeed()
print(agent:GetSpeed() < 7.1)  --> true)",
     true},
    {"Agent.Push", kCall<Push>, kError, "agent: Agent, force: Vector, time: number [s]", "",
     "Pushes the agent with its maximum force during the next step, which lasts this long. The direction is that of "
     "the force along the ground; its y is ignored. Also turns the agent towards its motion.",
     R"(agent:Push(agent:ForceToPosition(Vector.new(9, 0, 0)), 1 / 30)
print(agent:GetForward().x > 0.99)  --> true)",
     true},
    {"Agent.WalkTo", kCall<WalkTo>, kError,
     "agent: Agent, position: Vector [m], time: number [s], lookAhead: number 0.1..1000 [s] = 1.5, weight: number = 3",
     "",
     "Walks towards a place during a step of this length, with the agent's maximum force and at most its top speed. "
     "Avoids agents and movable objects that are less than lookAhead seconds away. The weight is that of avoiding, "
     "relative to the force towards the place.",
     R"(agent:WalkTo(Vector.new(9, 0, 0), 1 / 30))", true},
    {"Agent.WalkToTarget", kCall<WalkToTarget>, kError,
     "agent: Agent, time: number [s], lookAhead: number 0.1..1000 [s] = 1.5, weight: number = 3", "",
     "Like Agent.WalkTo, but to the agent's target.",
     R"(agent:SetTarget(Vector.new(9, 0, 0))
agent:WalkToTarget(1 / 30)
print(agent:GetForward().x > 0.99)  --> true)",
     true},
};

}  // namespace

std::span<const ApiFunction> AgentStrideApi() {
  return kAgentStrideFunctions;
}

}  // namespace soarbox::script
