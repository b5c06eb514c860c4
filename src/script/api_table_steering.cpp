// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

// Agent: steering forces. They are directions to be weighted and added, not forces in newtons.

namespace soarbox::script {
namespace {

constexpr ApiFunction kSteeringFunctions[] = {
    {"Agent.ClampSpeed", "agent: Agent", "",
     "Limits the horizontal speed to the agent's top speed. Jumps and falls are not affected.",
     R"(agent:SetVelocity(Vector.new(30, 0, 40))
agent:ClampSpeed()
print(agent:GetSpeed() < 7.1)  --> true)",
     true},
    {"Agent.ForceToAlign", "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: Agents = everybody",
     "Vector",
     "A force towards the average direction that the neighbours face. Neighbours are the agents within the distance "
     "and "
     "within the angle on either side of the front (180 is all around). The force has length 1; without neighbours it "
     "is zero. `agents` selects who can be a neighbour: everybody if you leave it out, a team if it is the team's "
     "name, "
     "or the agents of a table. Without a table, only agents nearby are read, so a large flock is much faster.",
     R"(local force = agent:ForceToAlign(10, 180, agent:GetTeam()))"},
    {"Agent.ForceToAvoidAgents", "agent: Agent, time: number 0.1..1000 [s] = 0.1", "Vector",
     "A force sideways to avoid a collision with another living agent within this time. It considers the first agent "
     "that would be hit.",
     R"(local force = agent:ForceToAvoidAgents(1.5) * 3)"},
    {"Agent.ForceToAvoidObjects", "agent: Agent, time: number 0.1..1000 [s] = 0.1", "Vector",
     "A force sideways to avoid movable objects that the agent would reach within this time. For fixed objects, use "
     "the navigation mesh.",
     R"(local force = agent:ForceToAvoidObjects(1.5) * 3)"},
    {"Agent.ForceToCombine",
     "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: Agents = everybody", "Vector",
     "A force towards the centre of the neighbours. Neighbours are defined as for ForceToAlign.",
     R"(local force = agent:ForceToCombine(100, 180, {other})
print(Vector.Length(force) > 0.99)  --> true)"},
    {"Agent.ForceToEvade", "agent: Agent, other: Agent, time: number [s] = 1", "Vector",
     "A force away from the predicted position of the other agent. The prediction looks ahead by at most this time.",
     R"(local force = agent:ForceToEvade(other))", true},
    {"Agent.ForceToFleePosition", "agent: Agent, position: Vector [m]", "Vector", "A force straight away from a place.",
     R"(print(agent:ForceToFleePosition(Vector.new(3, 0.8, 0)).x)  --> -3)"},
    {"Agent.ForceToFollowPath", "agent: Agent, time: number 0.1..1000 [s] = 0.1, unused: value = nil", "Vector",
     "A force back to the path if the agent would leave it within this time, or forwards along the path if it would go "
     "backwards.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
local force = agent:ForceToFollowPath(0.5) + agent:ForceToTargetSpeed(3))"},
    {"Agent.ForceToPosition", "agent: Agent, position: Vector [m]", "Vector", "A force straight towards a place.",
     R"(print(agent:ForceToPosition(Vector.new(3, 0.8, 0)).x)  --> 3)"},
    {"Agent.ForceToPursue", "agent: Agent, other: Agent, time: number [s] = 1", "Vector",
     "A force towards the predicted position of the other agent. The prediction looks ahead by at most this time.",
     R"(local force = agent:ForceToPursue(other))", true},
    {"Agent.ForceToSeparate",
     "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: Agents = everybody", "Vector",
     "A force away from the neighbours; the nearer they are, the stronger it is. Neighbours are defined as for "
     "ForceToAlign.",
     R"(print(agent:ForceToSeparate(10, 180) == agent:ForceToSeparate(10, 180, "team1"))  --> true)"},
    {"Agent.ForceToStayOnPath", "agent: Agent, time: number 0.1..1000 [s] = 0.1, unused: value = nil", "Vector",
     "A force back to the path if the agent would leave it within this time.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
local force = agent:ForceToStayOnPath(0.5))"},
    {"Agent.ForceToTargetSpeed", "agent: Agent, speed: number [m/s]", "Vector",
     "A force forwards or backwards that brings the agent to this speed, limited to its maximum force.",
     R"(print(agent:ForceToTargetSpeed(3).z)  --> 3)"},
    {"Agent.ForceToWander", "agent: Agent, delta: number [ms]", "Vector",
     "A direction to the side and up or down that changes at random. The larger delta is, the larger the changes are. "
     "With 33, the duration of a step, the direction jumps from side to side.",
     R"(local force = agent:ForceToWander(33))"},
    {"Agent.Push", "agent: Agent, force: Vector, time: number [s]", "",
     "Pushes the agent with its maximum force during the next step, which lasts this long. The direction is that of "
     "the force along the ground; its y is ignored. Also turns the agent towards its motion.",
     R"(agent:Push(agent:ForceToPosition(Vector.new(9, 0, 0)), 1 / 30)
print(agent:GetForward().x > 0.99)  --> true)",
     true},
    {"Agent.WalkTo",
     "agent: Agent, position: Vector [m], time: number [s], lookAhead: number 0.1..1000 [s] = 1.5, weight: number = 3",
     "",
     "Walks towards a place during a step of this length, with the agent's maximum force and at most its top speed. "
     "Avoids agents and movable objects that are less than lookAhead seconds away. The weight is that of avoiding, "
     "relative to the force towards the place.",
     R"(agent:WalkTo(Vector.new(9, 0, 0), 1 / 30))", true},
    {"Agent.WalkToTarget", "agent: Agent, time: number [s], lookAhead: number 0.1..1000 [s] = 1.5, weight: number = 3",
     "", "Like Agent.WalkTo, but to the agent's target.",
     R"(agent:SetTarget(Vector.new(9, 0, 0))
agent:WalkToTarget(1 / 30)
print(agent:GetForward().x > 0.99)  --> true)",
     true},
};

}  // namespace

std::span<const ApiFunction> AgentSteeringApi() {
  return kSteeringFunctions;
}

}  // namespace soarbox::script
