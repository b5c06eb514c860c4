// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

// Agent: properties of agents. The steering functions are in api_table_steering.cpp.

namespace soarbox::script {
namespace {

constexpr ApiFunction kAgentFunctions[] = {
    {"Agent.ApplyForce", "agent: Agent, force: Vector -1e12..1e12 [N]", "",
     "Pushes the agent during the next step. The forces of one step add up. An agent without a body does not move.",
     R"(agent:ApplyForce(Vector.new(0, 0, 500)))"},
    {"Agent.GetDistanceAlongPath", "agent: Agent, point: Vector [m]", "number [m]",
     "The distance along the path to the point of the path that is nearest to this one; nothing without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetDistanceAlongPath(Vector.new(2, 0, 4)))  --> 4)"},
    {"Agent.GetForward", "agent: Agent", "Vector", "The direction that the agent faces, with length 1.",
     R"(print(agent:GetForward().z)  --> 1)"},
    {"Agent.GetHealth", "agent: Agent", "number",
     "The agent's health; initially 100. At 0 or below, the agent counts as dead.",
     R"(print(agent:GetHealth())  --> 100)"},
    {"Agent.GetHeight", "agent: Agent", "number [m]", "The height of the agent's capsule; initially 1.6.",
     R"(print(string.format("%.1f", agent:GetHeight()))  --> 1.6)"},
    {"Agent.GetId", "agent: Agent", "number", "The agent's number, which no other agent or object has.",
     R"(print(agent:GetId() ~= other:GetId())  --> true)"},
    {"Agent.GetLeader", "agent: Agent", "Agent", "The agent that this one follows; nothing if it has no leader.",
     R"(agent:SetLeader(other)
print(agent:GetLeader() == other)  --> true)",
     true},
    {"Agent.GetLeft", "agent: Agent", "Vector", "The direction to the agent's left, with length 1.",
     R"(print(agent:GetLeft().x)  --> 1)"},
    {"Agent.GetMass", "agent: Agent", "number [kg]", "The agent's mass; initially 90.7.",
     R"(print(string.format("%.1f", agent:GetMass()))  --> 90.7)"},
    {"Agent.GetMaxForce", "agent: Agent", "number [N]",
     "The maximum force of ForceToTargetSpeed, Push and WalkTo; initially 1000. It does not limit ApplyForce.",
     R"(print(agent:GetMaxForce())  --> 1000)"},
    {"Agent.GetMaxSpeed", "agent: Agent", "number [m/s]",
     "The top speed of WalkTo, WalkToTarget and ClampSpeed; initially 7. Forces and SetVelocity can make the agent "
     "faster.",
     R"(print(agent:GetMaxSpeed())  --> 7)"},
    {"Agent.GetNeighbours", "agent: Agent, distance: number 0..1e6 [m], team: string = any", "table",
     "The agents within a distance, without the agent itself, in the order of their creation. With a team, only the "
     "agents of that team. The cost depends only on the number of agents nearby, so it is low even in a flock of "
     "1,000.",
     R"(print(#agent:GetNeighbours(10))  --> 1)", true},
    {"Agent.GetNearestPointOnPath", "agent: Agent, point: Vector [m]", "Vector [m]",
     "The point on the path nearest to this one; nothing without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetNearestPointOnPath(Vector.new(2, 0, 4)).z)  --> 4)"},
    {"Agent.GetPath", "agent: Agent", "table of Vector [m]",
     "A copy of the path's points, with the first one repeated at the end if the path is cyclic; {} without a path.",
     R"(print(#agent:GetPath())  --> 0)"},
    {"Agent.GetPointOnPath", "agent: Agent, distance: number [m]", "Vector [m]",
     "The point on the path at this distance from its start. Beyond the ends, it is the nearest end, or it wraps "
     "around if the path is cyclic. Nothing without a path.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
print(agent:GetPointOnPath(4).z)  --> 4)"},
    {"Agent.GetPosition", "agent: Agent", "Vector [m]",
     "The position of the agent's centre; its feet are half its height below.",
     R"(print(string.format("%.1f", agent:GetPosition().y))  --> 0.8)"},
    {"Agent.GetRadius", "agent: Agent", "number [m]", "The radius of the agent's capsule; initially 0.3.",
     R"(print(string.format("%.1f", agent:GetRadius()))  --> 0.3)"},
    {"Agent.GetSandbox", "agent: Agent", "Sandbox", "The sandbox that the agent is in.",
     R"(local all = Sandbox.GetAgents(agent:GetSandbox())
print(#all)  --> 2)"},
    {"Agent.GetScore", "agent: Agent", "number", "The agent's score; nothing if it was never set.",
     R"(agent:SetScore(12)
print(agent:GetScore())  --> 12)",
     true},
    {"Agent.GetSpeed", "agent: Agent", "number [m/s]", "The agent's speed over the ground; falling does not count.",
     R"(print(agent:GetSpeed())  --> 0)"},
    {"Agent.GetTarget", "agent: Agent", "Vector [m]", "A copy of the target set by SetTarget.",
     R"(print(agent:GetTarget().x)  --> 0)"},
    {"Agent.GetTargetRadius", "agent: Agent", "number [m]",
     "The distance at which the target counts as reached; initially 0.5.",
     R"(print(agent:GetTargetRadius())  --> 0.5)"},
    {"Agent.GetTeam", "agent: Agent", "string", "The agent's team; initially \"team1\".",
     R"(print(agent:GetTeam())  --> team1)"},
    {"Agent.GetUp", "agent: Agent", "Vector", "The agent's up direction, with length 1.",
     R"(print(agent:GetUp().y)  --> 1)"},
    {"Agent.GetVelocity", "agent: Agent", "Vector [m/s]", "The agent's velocity, including falling.",
     R"(agent:SetVelocity(Vector.new(0, 0, 2))
print(agent:GetVelocity().z)  --> 2)"},
    {"Agent.HasPath", "agent: Agent", "boolean", "Whether the agent has a path.",
     R"(print(agent:HasPath())  --> false)"},
    {"Agent.IsAgent", "value: value", "boolean", "Whether a value is an agent.",
     R"(print(Agent.IsAgent(agent), Agent.IsAgent(object))  --> true	false)"},
    {"Agent.PredictFuturePosition", "agent: Agent, time: number 0..1e6 [s]", "Vector [m]",
     "Where the agent will be after this time if it keeps its velocity.",
     R"(agent:SetVelocity(Vector.new(2, 0, 0))
print(agent:PredictFuturePosition(1.5).x)  --> 3)"},
    {"Agent.RemovePath", "agent: Agent", "",
     "Removes the path. ForceToFollowPath and ForceToStayOnPath keep using the old points until the next SetPath.",
     R"(agent:RemovePath()
print(agent:HasPath())  --> false)"},
    {"Agent.RemovePhysics", "agent: Agent", "",
     "Removes the agent's body for good. Nothing collides with it any more, and only SetPosition moves it.",
     R"(agent:RemovePhysics())"},
    {"Agent.Self", "", "Agent",
     "The agent that the calling script belongs to; nil in the sandbox's own scripts. Use it in modules that do not "
     "get the agent as an argument.",
     R"(print(Agent.Self())  --> nil)", true},
    {"Agent.SetForward", "agent: Agent, direction: Vector", "",
     "Turns the agent. A direction without a horizontal part changes nothing.",
     R"(agent:SetForward(Vector.new(1, 0, 0)))"},
    {"Agent.SetHealth", "agent: Agent, health: number", "", "Sets the agent's health, without limits.",
     R"(agent:SetHealth(agent:GetHealth() - 5)
print(agent:GetHealth())  --> 95)"},
    {"Agent.SetHeight", "agent: Agent, height: number 0..100000 [m]", "",
     "Gives the agent a body of another height around the same centre. The agent stops.", R"(agent:SetHeight(1.3))"},
    {"Agent.SetLeader", "agent: Agent, leader: value", "", "Sets the agent to follow; nil for nobody.",
     R"(agent:SetLeader(other))", true},
    {"Agent.SetMass", "agent: Agent, mass: number [kg]", "", "Changes the agent's mass; 0 makes it immovable.",
     R"(agent:SetMass(60))"},
    {"Agent.SetMaxForce", "agent: Agent, force: number 0..1e12 [N]", "", "See GetMaxForce.",
     R"(agent:SetMaxForce(1500))"},
    {"Agent.SetMaxSpeed", "agent: Agent, speed: number 0..1e6 [m/s]", "", "See GetMaxSpeed.",
     R"(agent:SetMaxSpeed(3))"},
    {"Agent.SetPath", "agent: Agent, points: table [m], cyclic: boolean = false", "",
     "Gives the agent a path: an array of vectors; other values in it are skipped. A copy of the first point closes a "
     "cyclic path. The path is as wide as the agent.",
     R"(agent:SetPath({Vector.new(), Vector.new(10, 0, 0), Vector.new(10, 0, 10)}, true)
print(#agent:GetPath())  --> 4)"},
    {"Agent.SetPosition", "agent: Agent, position: Vector -1e6..1e6 [m]", "",
     "Moves the agent's centre to a place at once. Its velocity stays the same.",
     R"(agent:SetPosition(Vector.new(4, agent:GetHeight() / 2, 0))
print(agent:GetPosition().x)  --> 4)"},
    {"Agent.SetRadius", "agent: Agent, radius: number 0..100000 [m]", "",
     "Gives the agent a body of another radius. The agent stops.", R"(agent:SetRadius(0.4))"},
    {"Agent.SetScore", "agent: Agent, score: number -1e9..1e9", "",
     "Sets the agent's score in a game. It is shown next to the agent's name, and missions and sweeps can use it.",
     R"(agent:SetScore(5))", true},
    {"Agent.SetSpeed", "agent: Agent, speed: number -100000..100000 [m/s]", "",
     "Sets the speed of an agent without a body; with one it has no effect.", R"(agent:RemovePhysics()
agent:SetSpeed(2)
print(agent:GetSpeed())  --> 2)"},
    {"Agent.SetTarget", "agent: Agent, target: Vector [m]", "",
     "Stores a place for scripts to use as a target. The agent does not go there by itself.",
     R"(agent:SetTarget(Vector.new(10, 0, 0))
print(agent:GetTarget().x)  --> 10)"},
    {"Agent.SetTargetRadius", "agent: Agent, radius: number 0..1e6 [m]", "", "See GetTargetRadius.",
     R"(agent:SetTargetRadius(1.5))"},
    {"Agent.SetTeam", "agent: Agent, team: string", "", "Puts the agent into a team.",
     R"(agent:SetTeam("team2")
print(agent:GetTeam())  --> team2)"},
    {"Agent.SetVelocity", "agent: Agent, velocity: Vector -100000..100000 [m/s]", "",
     "Changes the agent's velocity at once.", R"(agent:SetVelocity(Vector.new(0, 5, 0)))"},
    {"Agent.Show", "agent: Agent, name: string, value: value = nil", "",
     "Shows a part of the agent's state to people, in the panel Mind and in recordings. The value is a number, a text, "
     "a vector or a table of such values, of any depth; nil removes it. In a table, `active = true` marks an entry "
     "that is chosen or in progress, and `name` and `value` are the text of the table's own line. List items are shown "
     "in their order, other fields sorted by name. Labels show the first value, or the one called \"doing\", as the "
     "agent's activity.",
     R"(agent:Show("state", "patrol")
agent:Show("scores", { attack = 0.2, flee = { value = 0.9, active = true } })
agent:Show("tree", { { name = "fight", active = true, { name = "reload", active = true }, { name = "shoot" } } }))",
     true},
};

}  // namespace

std::span<const ApiFunction> AgentApi() {
  return kAgentFunctions;
}

}  // namespace soarbox::script
