// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "world/agent_stride.h"

// Agent: from steering to motion. Scripts call these functions for each agent in each step, so they are not written in
// Lua.

namespace soarbox::script {
namespace {

using world::Agent;
using world::Vec3;

/// The caller's force, made horizontal if the agent can be pushed.
Vec3 FlattenedForce(lua_State* state, const Agent& agent) {
  Vec3* force = ToVector(state, 2);
  if (force == nullptr) return CheckVector(state, 2);
  const Vec3 before = *force;
  if (agent.Mass() > 0) force->y = 0;
  return before;
}

/// Pushes the agent along the ground for this step, up to its maximum speed.
void Stride(lua_State* state, Agent& agent, Vec3 force, double step_s) {
  WarnUnless(state, PushAlongGround(agent, force, step_s));
  ClampHorizontalSpeed(agent);
}

int Push(lua_State* state) {
  Agent& agent = AgentArgument(state, 1);
  const double step_s = luaL_checknumber(state, 3);
  WarnUnless(state, PushAlongGround(agent, FlattenedForce(state, agent), step_s));
  return 0;
}

int ClampSpeed(lua_State* state) {
  ClampHorizontalSpeed(AgentArgument(state, 1));
  return 0;
}

/// Reads ([look-ahead in seconds [, weight]]) from `index` on.
world::GivingWay GivingWayArguments(lua_State* state, int index) {
  world::GivingWay giving_way;
  if (lua_gettop(state) >= index) giving_way.look_ahead_s = CheckFloat(state, index);
  if (lua_gettop(state) > index) giving_way.weight = CheckFloat(state, index + 1);
  return giving_way;
}

/// (agent, position, seconds [, look-ahead in seconds [, weight]])
int WalkTo(lua_State* state) {
  Agent& agent = AgentArgument(state, 1);
  const Vec3 goal = CheckVector(state, 2);
  const double step_s = luaL_checknumber(state, 3);
  Stride(state, agent, ForceToWalk(agent, goal, GivingWayArguments(state, 4)), step_s);
  return 0;
}

/// (agent, seconds [, look-ahead in seconds [, weight]])
int WalkToTarget(lua_State* state) {
  Agent& agent = AgentArgument(state, 1);
  const double step_s = luaL_checknumber(state, 2);
  Stride(state, agent, ForceToWalk(agent, agent.Target(), GivingWayArguments(state, 3)), step_s);
  return 0;
}

constexpr Binding kAgentStrideBindings[] = {
    {"ClampSpeed", ClampSpeed, 1, 1, WrongCount::kError},
    {"Push", Push, 3, 3, WrongCount::kError},
    {"WalkTo", WalkTo, 3, 5, WrongCount::kError},
    {"WalkToTarget", WalkToTarget, 2, 4, WrongCount::kError},
};

}  // namespace

void BindAgentStride(lua_State* state) {
  RegisterTable(state, "Agent", kAgentStrideBindings);
}

}  // namespace soarbox::script
