// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

// Agent: what agents are and have; steering stands apart.

namespace soarbox::script {
namespace {

constexpr ApiFunction kFunctions[] = {
    {"Agent.ApplyForce", "agent: Agent, force: Vector -1e12..1e12 [N]", "",
     "Pushes the agent during the next step. Forces of one step add up; an agent without a body is not moved.",
     R"(agent:ApplyForce(Vector.new(0, 0, 500)))"},
    {"Agent.GetDistanceAlongPath", "agent: Agent, point: Vector [m]", "number [m]",
     "How far along the path its nearest point to this one is; nothing without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetDistanceAlongPath(Vector.new(2, 0, 4)))  --> 4)"},
    {"Agent.GetForward", "agent: Agent", "Vector", "Where the agent faces; of length 1.",
     R"(print(agent:GetForward().z)  --> 1)"},
    {"Agent.GetHealth", "agent: Agent", "number", "The agent's health; 100 at first. At 0 and below it counts as dead.",
     R"(print(agent:GetHealth())  --> 100)"},
    {"Agent.GetHeight", "agent: Agent", "number [m]", "The height of the agent's capsule; 1.6 at first.",
     R"(print(string.format("%.1f", agent:GetHeight()))  --> 1.6)"},
    {"Agent.GetId", "agent: Agent", "number", "The number of the agent: no other agent or object has it.",
     R"(print(agent:GetId() ~= other:GetId())  --> true)"},
    {"Agent.GetLeader", "agent: Agent", "Agent", "Whom the agent follows; nothing if it has no leader.",
     R"(agent:SetLeader(other)
print(agent:GetLeader() == other)  --> true)",
     true},
    {"Agent.GetLeft", "agent: Agent", "Vector", "The direction to the agent's left; of length 1.",
     R"(print(agent:GetLeft().x)  --> 1)"},
    {"Agent.GetMass", "agent: Agent", "number [kg]", "The agent's mass; 90.7 at first.",
     R"(print(string.format("%.1f", agent:GetMass()))  --> 90.7)"},
    {"Agent.GetMaxForce", "agent: Agent", "number [N]",
     "The strongest force that scripts and ForceToTargetSpeed let the agent use; 1000 at first.",
     R"(print(agent:GetMaxForce())  --> 1000)"},
    {"Agent.GetMaxSpeed", "agent: Agent", "number [m/s]",
     "The speed that scripts keep the agent below; 7 at first. The world does not enforce it.",
     R"(print(agent:GetMaxSpeed())  --> 7)"},
    {"Agent.GetNearestPointOnPath", "agent: Agent, point: Vector [m]", "Vector [m]",
     "The point of the path that is nearest to this one; nothing without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetNearestPointOnPath(Vector.new(2, 0, 4)).z)  --> 4)"},
    {"Agent.GetPath", "agent: Agent", "table of Vector [m]",
     "A copy of the path's points, the first one again at the end if it is cyclic; {} without a path.",
     R"(print(#agent:GetPath())  --> 0)"},
    {"Agent.GetPointOnPath", "agent: Agent, distance: number [m]", "Vector [m]",
     "The point of the path this far from its start: its ends beyond them, and round and round if it is cyclic. "
     "Nothing "
     "without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetPointOnPath(4).z)  --> 4)"},
    {"Agent.GetPosition", "agent: Agent", "Vector [m]",
     "Where the middle of the agent is; its feet are half its height below.",
     R"(print(string.format("%.1f", agent:GetPosition().y))  --> 0.8)"},
    {"Agent.GetRadius", "agent: Agent", "number [m]", "The radius of the agent's capsule; 0.3 at first.",
     R"(print(string.format("%.1f", agent:GetRadius()))  --> 0.3)"},
    {"Agent.GetSandbox", "agent: Agent", "Sandbox", "The sandbox that the agent lives in.",
     R"(local all = Sandbox.GetAgents(agent:GetSandbox())
print(#all)  --> 2)"},
    {"Agent.GetSpeed", "agent: Agent", "number [m/s]",
     "How fast the agent moves over the ground; falling does not count.", R"(print(agent:GetSpeed())  --> 0)"},
    {"Agent.GetTarget", "agent: Agent", "Vector [m]", "A copy of the target that SetTarget keeps.",
     R"(print(agent:GetTarget().x)  --> 0)"},
    {"Agent.GetTargetRadius", "agent: Agent", "number [m]", "How near the target counts as reached; 0.5 at first.",
     R"(print(agent:GetTargetRadius())  --> 0.5)"},
    {"Agent.GetTeam", "agent: Agent", "string", "The agent's team; \"team1\" at first.",
     R"(print(agent:GetTeam())  --> team1)"},
    {"Agent.GetUp", "agent: Agent", "Vector", "The direction above the agent's head; of length 1.",
     R"(print(agent:GetUp().y)  --> 1)"},
    {"Agent.GetVelocity", "agent: Agent", "Vector [m/s]", "How the agent moves, falling included.",
     R"(agent:SetVelocity(Vector.new(0, 0, 2))
print(agent:GetVelocity().z)  --> 2)"},
    {"Agent.HasPath", "agent: Agent", "boolean", "Whether the agent has a path.",
     R"(print(agent:HasPath())  --> false)"},
    {"Agent.IsAgent", "value: value", "boolean", "Whether a value is an agent.",
     R"(print(Agent.IsAgent(agent), Agent.IsAgent(object))  --> true	false)"},
    {"Agent.PredictFuturePosition", "agent: Agent, time: number 0..1e6 [s]", "Vector [m]",
     "Where the agent will be if it goes on as it moves now.",
     R"(agent:SetVelocity(Vector.new(2, 0, 0))
print(agent:PredictFuturePosition(1.5).x)  --> 3)"},
    {"Agent.RemovePath", "agent: Agent", "",
     "Forgets the path. ForceToFollowPath and ForceToStayOnPath go on along the old points until the next SetPath.",
     R"(agent:RemovePath()
print(agent:HasPath())  --> false)"},
    {"Agent.RemovePhysics", "agent: Agent", "",
     "Takes the agent's body away for good: nothing meets it and only SetPosition moves it.",
     R"(agent:RemovePhysics())"},
    {"Agent.SetForward", "agent: Agent, direction: Vector", "",
     "Turns the agent. A direction without a horizontal part changes nothing.",
     R"(agent:SetForward(Vector.new(1, 0, 0)))"},
    {"Agent.SetHealth", "agent: Agent, health: number", "", "Sets the agent's health; no limits are kept.",
     R"(agent:SetHealth(agent:GetHealth() - 5)
print(agent:GetHealth())  --> 95)"},
    {"Agent.SetHeight", "agent: Agent, height: number 0..100000 [m]", "",
     "Gives the agent a body of another height around the same middle; it comes to a stand.",
     R"(agent:SetHeight(1.3))"},
    {"Agent.SetLeader", "agent: Agent, leader: value", "", "Whom the agent follows; nil for nobody.",
     R"(agent:SetLeader(other))", true},
    {"Agent.SetMass", "agent: Agent, mass: number [kg]", "", "Changes the agent's mass; 0 nails it down.",
     R"(agent:SetMass(60))"},
    {"Agent.SetMaxForce", "agent: Agent, force: number 0..1e12 [N]", "", "See GetMaxForce.",
     R"(agent:SetMaxForce(1500))"},
    {"Agent.SetMaxSpeed", "agent: Agent, speed: number 0..1e6 [m/s]", "", "See GetMaxSpeed.",
     R"(agent:SetMaxSpeed(3))"},
    {"Agent.SetPath", "agent: Agent, points: table [m], cyclic: boolean = false", "",
     "Gives the agent a path: an array of vectors, in which other values are skipped. A cyclic one is closed by a copy "
     "of "
     "its first point. The path is as wide as the agent.",
     R"(agent:SetPath({Vector.new(), Vector.new(10, 0, 0), Vector.new(10, 0, 10)}, true)
print(#agent:GetPath())  --> 4)"},
    {"Agent.SetPosition", "agent: Agent, position: Vector -1e6..1e6 [m]", "",
     "Puts the agent's middle somewhere at once; its velocity stays.",
     R"(agent:SetPosition(Vector.new(4, agent:GetHeight() / 2, 0))
print(agent:GetPosition().x)  --> 4)"},
    {"Agent.SetRadius", "agent: Agent, radius: number 0..100000 [m]", "",
     "Gives the agent a body of another radius; it comes to a stand.", R"(agent:SetRadius(0.4))"},
    {"Agent.SetSpeed", "agent: Agent, speed: number -100000..100000 [m/s]", "",
     "Sets the speed of an agent without a body; with one it has no effect.", R"(agent:RemovePhysics()
agent:SetSpeed(2)
print(agent:GetSpeed())  --> 2)"},
    {"Agent.SetTarget", "agent: Agent, target: Vector [m]", "",
     "Keeps a place for scripts to go to; nothing goes there by itself.",
     R"(agent:SetTarget(Vector.new(10, 0, 0))
print(agent:GetTarget().x)  --> 10)"},
    {"Agent.SetTargetRadius", "agent: Agent, radius: number 0..1e6 [m]", "", "See GetTargetRadius.",
     R"(agent:SetTargetRadius(1.5))"},
    {"Agent.SetTeam", "agent: Agent, team: string", "", "Puts the agent into a team.",
     R"(agent:SetTeam("team2")
print(agent:GetTeam())  --> team2)"},
    {"Agent.SetVelocity", "agent: Agent, velocity: Vector -100000..100000 [m/s]", "",
     "Changes how the agent moves, at once.", R"(agent:SetVelocity(Vector.new(0, 5, 0)))"},
};

}  // namespace

std::span<const ApiFunction> AgentApi() {
  return kFunctions;
}

}  // namespace soarbox::script
