// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <optional>
#include <vector>

#include "script/api_call.h"
#include "script/argument_check.h"
#include "world/agent.h"

// Agent: properties, position, path and leader. All are methods of agent handles too.

namespace soarbox::script {
namespace {

using world::Agent;
using world::Vec3;
using enum WrongCount;

std::uint32_t GetId(const Agent& agent) {
  return Number(agent.id());
}

Handle GetSandbox(const Agent&) {
  return {ValueKind::kSandbox, 0};
}

int IsAgent(lua_State* state) {
  const Handle* handle = ToHandle(state, 1);
  lua_pushboolean(state, handle && handle->kind == ValueKind::kAgent);
  return 1;
}

/// In the thesis' world, the agent's mass may be any number, but not the body's.
void SetMass(lua_State* state, Agent& agent, float mass) {
  if (mass < 0) WarnAtCallerOnce(state, "the mass is below 0 kg: the body counts as fixed, as with 0 kg", "mass");
  WarnUnless(state, agent.SetMass(mass));
}

void SetSpeed(lua_State* state, Agent& agent, float speed) {
  if (agent.HasBody()) {
    WarnIgnored(state, "the agent has a body, which SetVelocity and forces move");
  } else {
    WarnUnless(state, agent.SetSpeed(speed));
  }
}

/// A direction without a horizontal part has no heading; the agent keeps its heading. There is no warning, because
/// scripts pass the velocities of agents that stand still.
void SetForward(Agent& agent, Vec3 forward) {
  agent.SetForward(forward);
}

void ApplyForce(lua_State* state, Agent& agent, Vec3 force) {
  if (agent.HasBody()) WarnUnless(state, agent.ApplyForce(force));
}

void SetPath(Agent& agent, const std::vector<Vec3>& points, bool cyclic) {
  agent.SetPath(points, cyclic);
}

/// Agent.SetLeader(agent, leader); nil removes the leader.
int SetLeader(lua_State* state) {
  Agent& agent = AgentArgument(state, 1);
  const world::EntityId leader = lua_isnil(state, 2) ? world::kNoEntity : AgentArgument(state, 2).id();
  if (leader == agent.id()) return ArgumentError(state, 2, "an agent cannot be its own leader");
  agent.SetLeader(leader);
  return 0;
}

std::optional<Handle> GetLeader(const Agent& agent) {
  if (agent.Leader() == world::kNoEntity) return std::nullopt;
  return Handle{ValueKind::kAgent, Number(agent.Leader())};
}

constexpr ApiFunction kAgentPropertiesFunctions[] = {
    {"Agent.ApplyForce", kCall<ApplyForce>, kIgnored, "agent: Agent, force: Vector -1e12..1e12 [N]", "",
     "Pushes the agent during the next step. The forces of one step add up. An agent without a body does not move.",
     R"(agent:ApplyForce(Vector.new(0, 0, 500)))"},
    {"Agent.GetDistanceAlongPath", kCall<&Agent::DistanceAlongPath>, kError, "agent: Agent, point: Vector [m]",
     "number [m]",
     "The distance along the path to the point of the path that is nearest to this one; nothing without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetDistanceAlongPath(Vector.new(2, 0, 4)))  --> 4)"},
    {"Agent.GetForward", kCall<&Agent::Forward>, kIgnored, "agent: Agent", "Vector",
     "The direction that the agent faces, with length 1.", R"(print(agent:GetForward().z)  --> 1)"},
    {"Agent.GetHealth", kCall<&Agent::Health>, kIgnored, "agent: Agent", "number",
     "The agent's health; initially 100. At 0 or below, the agent counts as dead.",
     R"(print(agent:GetHealth())  --> 100)"},
    {"Agent.GetHeight", kCall<&Agent::Height>, kIgnored, "agent: Agent", "number [m]",
     "The height of the agent's capsule; initially 1.6.",
     R"(print(string.format("%.1f", agent:GetHeight()))  --> 1.6)"},
    {"Agent.GetId", kCall<GetId>, kIgnored, "agent: Agent", "number",
     "The agent's number, which no other agent or object has.", R"(print(agent:GetId() ~= other:GetId())  --> true)"},
    {"Agent.GetLeader", kCall<GetLeader>, kIgnored, "agent: Agent", "Agent",
     "The agent that this one follows; nothing if it has no leader.",
     R"(agent:SetLeader(other)
print(agent:GetLeader() == other)  --> true)",
     true},
    {"Agent.GetLeft", kCall<&Agent::Left>, kIgnored, "agent: Agent", "Vector",
     "The direction to the agent's left, with length 1.", R"(print(agent:GetLeft().x)  --> 1)"},
    {"Agent.GetMass", kCall<&Agent::Mass>, kIgnored, "agent: Agent", "number [kg]", "The agent's mass; initially 90.7.",
     R"(print(string.format("%.1f", agent:GetMass()))  --> 90.7)"},
    {"Agent.GetMaxForce", kCall<&Agent::MaxForce>, kIgnored, "agent: Agent", "number [N]",
     "The maximum force of ForceToTargetSpeed, Push and WalkTo; initially 1000. It does not limit ApplyForce.",
     R"(print(agent:GetMaxForce())  --> 1000)"},
    {"Agent.GetMaxSpeed", kCall<&Agent::MaxSpeed>, kIgnored, "agent: Agent", "number [m/s]",
     "The top speed of WalkTo, WalkToTarget and ClampSpeed; initially 7. Forces and SetVelocity can make the agent "
     "faster.",
     R"(print(agent:GetMaxSpeed())  --> 7)"},
    {"Agent.GetNearestPointOnPath", kCall<&Agent::NearestPointOnPath>, kError, "agent: Agent, point: Vector [m]",
     "Vector [m]", "The point on the path nearest to this one; nothing without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetNearestPointOnPath(Vector.new(2, 0, 4)).z)  --> 4)"},
    {"Agent.GetPath", kCall<&Agent::PathPoints>, kIgnored, "agent: Agent", "table of Vector [m]",
     "A copy of the path's points, with the first one repeated at the end if the path is cyclic; {} without a path.",
     R"(print(#agent:GetPath())  --> 0)"},
    {"Agent.GetPointOnPath", kCall<&Agent::PointOnPath>, kError, "agent: Agent, distance: number [m]", "Vector [m]",
     "The point on the path at this distance from its start. Beyond the ends, it is the nearest end, or it wraps "
     "around if the path is cyclic. Nothing without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetPointOnPath(4).z)  --> 4)"},
    {"Agent.GetPosition", kCall<&Agent::Position>, kIgnored, "agent: Agent", "Vector [m]",
     "The position of the agent's centre; its feet are half its height below.",
     R"(print(string.format("%.1f", agent:GetPosition().y))  --> 0.8)"},
    {"Agent.GetRadius", kCall<&Agent::Radius>, kIgnored, "agent: Agent", "number [m]",
     "The radius of the agent's capsule; initially 0.3.",
     R"(print(string.format("%.1f", agent:GetRadius()))  --> 0.3)"},
    {"Agent.GetSandbox", kCall<GetSandbox>, kIgnored, "agent: Agent", "Sandbox", "The sandbox that the agent is in.",
     R"(local all = Sandbox.GetAgents(agent:GetSandbox())
print(#all)  --> 2)"},
    {"Agent.GetScore", kCall<&Agent::Score>, kError, "agent: Agent", "number",
     "The agent's score; nothing if it was never set.",
     R"(agent:SetScore(12)
print(agent:GetScore())  --> 12)",
     true},
    {"Agent.GetSpeed", kCall<&Agent::Speed>, kIgnored, "agent: Agent", "number [m/s]",
     "The agent's speed over the ground; falling does not count.", R"(print(agent:GetSpeed())  --> 0)"},
    {"Agent.GetTarget", kCall<&Agent::Target>, kIgnored, "agent: Agent", "Vector [m]",
     "A copy of the target set by SetTarget.", R"(print(agent:GetTarget().x)  --> 0)"},
    {"Agent.GetTargetRadius", kCall<&Agent::TargetRadius>, kIgnored, "agent: Agent", "number [m]",
     "The distance at which the target counts as reached; initially 0.5.",
     R"(print(agent:GetTargetRadius())  --> 0.5)"},
    {"Agent.GetTeam", kCall<&Agent::Team>, kIgnored, "agent: Agent", "string", "The agent's team; initially \"team1\".",
     R"(print(agent:GetTeam())  --> team1)"},
    {"Agent.GetUp", kCall<&Agent::Up>, kIgnored, "agent: Agent", "Vector", "The agent's up direction, with length 1.",
     R"(print(agent:GetUp().y)  --> 1)"},
    {"Agent.GetVelocity", kCall<&Agent::Velocity>, kIgnored, "agent: Agent", "Vector [m/s]",
     "The agent's velocity, including falling.",
     R"(agent:SetVelocity(Vector.new(0, 0, 2))
print(agent:GetVelocity().z)  --> 2)"},
    {"Agent.HasPath", kCall<&Agent::HasPath>, kIgnored, "agent: Agent", "boolean", "Whether the agent has a path.",
     R"(print(agent:HasPath())  --> false)"},
    {"Agent.IsAgent", IsAgent, kError, "value: value", "boolean", "Whether a value is an agent.",
     R"(print(Agent.IsAgent(agent), Agent.IsAgent(object))  --> true	false)"},
    {"Agent.PredictFuturePosition", kCall<&Agent::PredictFuturePosition>, kError,
     "agent: Agent, time: number 0..1e6 [s]", "Vector [m]",
     "Where the agent will be after this time if it keeps its velocity.",
     R"(agent:SetVelocity(Vector.new(2, 0, 0))
print(agent:PredictFuturePosition(1.5).x)  --> 3)"},
    {"Agent.RemovePath", kCall<&Agent::RemovePath>, kError, "agent: Agent", "",
     "Removes the path. ForceToFollowPath and ForceToStayOnPath keep using the old points until the next SetPath.",
     R"(agent:RemovePath()
print(agent:HasPath())  --> false)"},
    {"Agent.RemovePhysics", kCall<&Agent::RemovePhysics>, kError, "agent: Agent", "",
     "Removes the agent's body for good. Nothing collides with it any more, and only SetPosition moves it.",
     R"(agent:RemovePhysics())"},
    {"Agent.SetForward", kCall<SetForward>, kError, "agent: Agent, direction: Vector", "",
     "Turns the agent. A direction without a horizontal part changes nothing.",
     R"(agent:SetForward(Vector.new(1, 0, 0)))"},
    {"Agent.SetHealth", kCall<&Agent::SetHealth>, kError, "agent: Agent, health: number", "",
     "Sets the agent's health, without limits.",
     R"(agent:SetHealth(agent:GetHealth() - 5)
print(agent:GetHealth())  --> 95)"},
    {"Agent.SetHeight", kCall<&Agent::SetHeight>, kError, "agent: Agent, height: number 0..100000 [m]", "",
     "Gives the agent a body of another height around the same centre. The agent stops.", R"(agent:SetHeight(1.3))"},
    {"Agent.SetLeader", SetLeader, kError, "agent: Agent, leader: value", "",
     "Sets the agent to follow; nil for nobody.", R"(agent:SetLeader(other))", true},
    {"Agent.SetMass", kCall<SetMass>, kError, "agent: Agent, mass: number [kg]", "",
     "Changes the agent's mass; 0 makes it immovable.", R"(agent:SetMass(60))"},
    {"Agent.SetMaxForce", kCall<&Agent::SetMaxForce>, kError, "agent: Agent, force: number 0..1e12 [N]", "",
     "See GetMaxForce.", R"(agent:SetMaxForce(1500))"},
    {"Agent.SetMaxSpeed", kCall<&Agent::SetMaxSpeed>, kError, "agent: Agent, speed: number 0..1e6 [m/s]", "",
     "See GetMaxSpeed.", R"(agent:SetMaxSpeed(3))"},
    {"Agent.SetPath", kCall<SetPath>, kError, "agent: Agent, points: table [m], cyclic: boolean = false", "",
     "Gives the agent a path: an array of vectors; other values in it are skipped. A copy of the first point closes a "
     "cyclic path. The path is as wide as the agent.",
     R"(agent:SetPath({Vector.new(), Vector.new(10, 0, 0), Vector.new(10, 0, 10)}, true)
print(#agent:GetPath())  --> 4)"},
    {"Agent.SetPosition", kCall<&Agent::SetPosition>, kError, "agent: Agent, position: Vector -1e6..1e6 [m]", "",
     "Moves the agent's centre to a place at once. Its velocity stays the same.",
     R"(agent:SetPosition(Vector.new(4, agent:GetHeight() / 2, 0))
print(agent:GetPosition().x)  --> 4)"},
    {"Agent.SetRadius", kCall<&Agent::SetRadius>, kError, "agent: Agent, radius: number 0..100000 [m]", "",
     "Gives the agent a body of another radius. The agent stops.", R"(agent:SetRadius(0.4))"},
    {"Agent.SetScore", kCall<&Agent::SetScore>, kError, "agent: Agent, score: number -1e9..1e9", "",
     "Sets the agent's score in a game. It is shown next to the agent's name, and missions and sweeps can use it.",
     R"(agent:SetScore(5))", true},
    {"Agent.SetSpeed", kCall<SetSpeed>, kError, "agent: Agent, speed: number -100000..100000 [m/s]", "",
     "Sets the speed of an agent without a body; with one it has no effect.", R"(agent:RemovePhysics()
agent:SetSpeed(2)
print(agent:GetSpeed())  --> 2)"},
    {"Agent.SetTarget", kCall<&Agent::SetTarget>, kError, "agent: Agent, target: Vector [m]", "",
     "Stores a place for scripts to use as a target. The agent does not go there by itself.",
     R"(agent:SetTarget(Vector.new(10, 0, 0))
print(agent:GetTarget().x)  --> 10)"},
    {"Agent.SetTargetRadius", kCall<&Agent::SetTargetRadius>, kError, "agent: Agent, radius: number 0..1e6 [m]", "",
     "See GetTargetRadius.", R"(agent:SetTargetRadius(1.5))"},
    {"Agent.SetTeam", kCall<&Agent::SetTeam>, kError, "agent: Agent, team: string", "", "Puts the agent into a team.",
     R"(agent:SetTeam("team2")
print(agent:GetTeam())  --> team2)"},
    {"Agent.SetVelocity", kCall<&Agent::SetVelocity>, kError, "agent: Agent, velocity: Vector -100000..100000 [m/s]",
     "", "Changes the agent's velocity at once.", R"(agent:SetVelocity(Vector.new(0, 5, 0)))"},
};

}  // namespace

std::span<const ApiFunction> AgentPropertiesApi() {
  return kAgentPropertiesFunctions;
}

}  // namespace soarbox::script
