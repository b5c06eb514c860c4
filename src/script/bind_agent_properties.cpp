// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"

// Agent: properties, position, path and leader. All are methods of agent handles too.

namespace soarbox::script {
namespace {

using world::Agent;
using world::Vec3;

int GetId(lua_State* state) {
  lua_pushnumber(state, Number(AgentArgument(state, 1).id()));
  return 1;
}

int GetSandbox(lua_State* state) {
  AgentArgument(state, 1);
  PushSandbox(state);
  return 1;
}

int IsAgent(lua_State* state) {
  const Handle* handle = ToHandle(state, 1);
  lua_pushboolean(state, handle && handle->kind == ValueKind::kAgent);
  return 1;
}

template <Vec3 (Agent::*Getter)() const>
int GetVector(lua_State* state) {
  PushVector(state, (AgentArgument(state, 1).*Getter)());
  return 1;
}

template <float (Agent::*Getter)() const>
int GetNumber(lua_State* state) {
  lua_pushnumber(state, (AgentArgument(state, 1).*Getter)());
  return 1;
}

template <bool (Agent::*Setter)(Vec3)>
int SetVector(lua_State* state) {
  const Vec3 vector = CheckVector(state, 2);
  WarnUnless(state, (AgentArgument(state, 1).*Setter)(vector));
  return 0;
}

template <bool (Agent::*Setter)(float)>
int SetNumber(lua_State* state) {
  const float number = CheckFloat(state, 2);
  WarnUnless(state, (AgentArgument(state, 1).*Setter)(number));
  return 0;
}

/// In the thesis' world, the agent's mass may be any number, but not the body's.
int SetMass(lua_State* state) {
  const float mass = CheckFloat(state, 2);
  Agent& agent = AgentArgument(state, 1);
  if (mass < 0) WarnAtCallerOnce(state, "the mass is below 0 kg: the body counts as fixed, as with 0 kg", "mass");
  WarnUnless(state, agent.SetMass(mass));
  return 0;
}

int SetSpeed(lua_State* state) {
  const float speed = CheckFloat(state, 2);
  Agent& agent = AgentArgument(state, 1);
  if (agent.HasBody()) {
    WarnIgnored(state, "the agent has a body, which SetVelocity and forces move");
  } else {
    WarnUnless(state, agent.SetSpeed(speed));
  }
  return 0;
}

/// A direction without a horizontal part has no heading; the agent keeps its heading. There is no warning, because
/// scripts pass the velocities of agents that stand still.
int SetForward(lua_State* state) {
  const Vec3 forward = CheckVector(state, 2);
  AgentArgument(state, 1).SetForward(forward);
  return 0;
}

int GetTeam(lua_State* state) {
  const std::string& team = AgentArgument(state, 1).Team();
  lua_pushlstring(state, team.data(), team.size());
  return 1;
}

int SetTeam(lua_State* state) {
  const std::string_view team = TextArgument(state, 2);
  AgentArgument(state, 1).SetTeam(team);
  return 0;
}

int PredictFuturePosition(lua_State* state) {
  const float seconds = CheckFloat(state, 2);
  PushVector(state, AgentArgument(state, 1).PredictFuturePosition(seconds));
  return 1;
}

int ApplyForce(lua_State* state) {
  const Vec3 force = CheckVector(state, 2);
  Agent& agent = AgentArgument(state, 1);
  if (agent.HasBody()) WarnUnless(state, agent.ApplyForce(force));
  return 0;
}

int RemovePhysics(lua_State* state) {
  AgentArgument(state, 1).RemovePhysics();
  return 0;
}

int SetPath(lua_State* state) {
  Agent& agent = AgentArgument(state, 1);
  agent.SetPath(VectorsArgument(state, 2), TruthArgument(state, 3));
  return 0;
}

int GetPath(lua_State* state) {
  const auto points = AgentArgument(state, 1).PathPoints();
  lua_createtable(state, static_cast<int>(points.size()), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    PushVector(state, points[i]);
    lua_rawseti(state, -2, static_cast<int>(i + 1));
  }
  return 1;
}

int HasPath(lua_State* state) {
  lua_pushboolean(state, AgentArgument(state, 1).HasPath());
  return 1;
}

int RemovePath(lua_State* state) {
  AgentArgument(state, 1).RemovePath();
  return 0;
}

int GetNearestPointOnPath(lua_State* state) {
  const Vec3 point = CheckVector(state, 2);
  const auto nearest = AgentArgument(state, 1).NearestPointOnPath(point);
  if (!nearest) return 0;
  PushVector(state, *nearest);
  return 1;
}

int GetDistanceAlongPath(lua_State* state) {
  const Vec3 point = CheckVector(state, 2);
  const auto distance = AgentArgument(state, 1).DistanceAlongPath(point);
  if (!distance) return 0;
  lua_pushnumber(state, *distance);
  return 1;
}

int GetPointOnPath(lua_State* state) {
  const float distance = CheckFloat(state, 2);
  const auto point = AgentArgument(state, 1).PointOnPath(distance);
  if (!point) return 0;
  PushVector(state, *point);
  return 1;
}

/// Agent.SetLeader(agent, leader); nil removes the leader.
int SetLeader(lua_State* state) {
  Agent& agent = AgentArgument(state, 1);
  const world::EntityId leader = lua_isnil(state, 2) ? world::kNoEntity : AgentArgument(state, 2).id();
  if (leader == agent.id()) return ArgumentError(state, 2, "an agent cannot be its own leader");
  agent.SetLeader(leader);
  return 0;
}

int GetLeader(lua_State* state) {
  const world::EntityId leader = AgentArgument(state, 1).Leader();
  if (leader == world::kNoEntity) return 0;
  PushAgent(state, leader);
  return 1;
}

int GetScore(lua_State* state) {
  const std::optional<float> score = AgentArgument(state, 1).Score();
  if (!score) return 0;
  lua_pushnumber(state, *score);
  return 1;
}

constexpr Binding kAgentPropertiesBindings[] = {
    {"ApplyForce", ApplyForce, 2, 2, WrongCount::kIgnored},
    {"GetDistanceAlongPath", GetDistanceAlongPath, 2, 2, WrongCount::kError},
    {"GetForward", GetVector<&Agent::Forward>, 1, 1, WrongCount::kIgnored},
    {"GetHealth", GetNumber<&Agent::Health>, 1, 1, WrongCount::kIgnored},
    {"GetHeight", GetNumber<&Agent::Height>, 1, 1, WrongCount::kIgnored},
    {"GetId", GetId, 1, 1, WrongCount::kIgnored},
    {"GetLeader", GetLeader, 1, 1, WrongCount::kIgnored},
    {"GetLeft", GetVector<&Agent::Left>, 1, 1, WrongCount::kIgnored},
    {"GetMass", GetNumber<&Agent::Mass>, 1, 1, WrongCount::kIgnored},
    {"GetMaxForce", GetNumber<&Agent::MaxForce>, 1, 1, WrongCount::kIgnored},
    {"GetMaxSpeed", GetNumber<&Agent::MaxSpeed>, 1, 1, WrongCount::kIgnored},
    {"GetNearestPointOnPath", GetNearestPointOnPath, 2, 2, WrongCount::kError},
    {"GetPath", GetPath, 1, 1, WrongCount::kIgnored},
    {"GetPointOnPath", GetPointOnPath, 2, 2, WrongCount::kError},
    {"GetPosition", GetVector<&Agent::Position>, 1, 1, WrongCount::kIgnored},
    {"GetRadius", GetNumber<&Agent::Radius>, 1, 1, WrongCount::kIgnored},
    {"GetSandbox", GetSandbox, 1, 1, WrongCount::kIgnored},
    {"GetScore", GetScore, 1, 1, WrongCount::kError},
    {"GetSpeed", GetNumber<&Agent::Speed>, 1, 1, WrongCount::kIgnored},
    {"GetTarget", GetVector<&Agent::Target>, 1, 1, WrongCount::kIgnored},
    {"GetTargetRadius", GetNumber<&Agent::TargetRadius>, 1, 1, WrongCount::kIgnored},
    {"GetTeam", GetTeam, 1, 1, WrongCount::kIgnored},
    {"GetUp", GetVector<&Agent::Up>, 1, 1, WrongCount::kIgnored},
    {"GetVelocity", GetVector<&Agent::Velocity>, 1, 1, WrongCount::kIgnored},
    {"HasPath", HasPath, 1, 1, WrongCount::kIgnored},
    {"IsAgent", IsAgent, 1, 1, WrongCount::kError},
    {"PredictFuturePosition", PredictFuturePosition, 2, 2, WrongCount::kError},
    {"RemovePath", RemovePath, 1, 1, WrongCount::kError},
    {"RemovePhysics", RemovePhysics, 1, 1, WrongCount::kError},
    {"SetForward", SetForward, 2, 2, WrongCount::kError},
    {"SetHealth", SetNumber<&Agent::SetHealth>, 2, 2, WrongCount::kError},
    {"SetHeight", SetNumber<&Agent::SetHeight>, 2, 2, WrongCount::kError},
    {"SetLeader", SetLeader, 2, 2, WrongCount::kError},
    {"SetMass", SetMass, 2, 2, WrongCount::kError},
    {"SetMaxForce", SetNumber<&Agent::SetMaxForce>, 2, 2, WrongCount::kError},
    {"SetMaxSpeed", SetNumber<&Agent::SetMaxSpeed>, 2, 2, WrongCount::kError},
    {"SetPath", SetPath, 2, 3, WrongCount::kError},
    {"SetPosition", SetVector<&Agent::SetPosition>, 2, 2, WrongCount::kError},
    {"SetRadius", SetNumber<&Agent::SetRadius>, 2, 2, WrongCount::kError},
    {"SetScore", SetNumber<&Agent::SetScore>, 2, 2, WrongCount::kError},
    {"SetSpeed", SetSpeed, 2, 2, WrongCount::kError},
    {"SetTarget", SetVector<&Agent::SetTarget>, 2, 2, WrongCount::kError},
    {"SetTargetRadius", SetNumber<&Agent::SetTargetRadius>, 2, 2, WrongCount::kError},
    {"SetTeam", SetTeam, 2, 2, WrongCount::kError},
    {"SetVelocity", SetVector<&Agent::SetVelocity>, 2, 2, WrongCount::kError},
};

}  // namespace

void BindAgentProperties(lua_State* state) {
  RegisterTable(state, "Agent", kAgentPropertiesBindings);
}

}  // namespace soarbox::script
