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
    {"Agent.ForceToAlign", "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: table = everybody",
     "Vector",
     "A force towards the average direction that the neighbours face. Neighbours are the agents of the list within the "
     "distance and within the angle on either side of the front (180 is all around). It has length 1, or is zero "
     "without neighbours. Leave the list out if everybody counts: in a large flock that is much faster.",
     R"(local force = agent:ForceToAlign(10, 180, Sandbox.GetAgents(sandbox)))"},
    {"Agent.ForceToAvoidAgents", "agent: Agent, time: number 0.1..1000 [s] = 0.1", "Vector",
     "Steers sideways to avoid the living agent that it would meet first within this time.",
     R"(local force = agent:ForceToAvoidAgents(1.5) * 3)"},
    {"Agent.ForceToAvoidObjects", "agent: Agent, time: number 0.1..1000 [s] = 0.1", "Vector",
     "Steers sideways to avoid movable objects that are ahead within this time. For fixed objects, use the navigation "
     "mesh.",
     R"(local force = agent:ForceToAvoidObjects(1.5) * 3)"},
    {"Agent.ForceToCombine",
     "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: table = everybody", "Vector",
     "A force towards the centre of the neighbours; ForceToAlign says which agents are neighbours.",
     R"(local force = agent:ForceToCombine(100, 180, {other})
print(Vector.Length(force) > 0.99)  --> true)"},
    {"Agent.ForceToEvade", "agent: Agent, other: Agent, time: number [s] = 1", "Vector",
     "Flees from where the other agent will be, looking at most this time ahead.",
     R"(local force = agent:ForceToEvade(other))", true},
    {"Agent.ForceToFleePosition", "agent: Agent, position: Vector [m]", "Vector", "A force straight away from a place.",
     R"(print(agent:ForceToFleePosition(Vector.new(3, 0.8, 0)).x)  --> -3)"},
    {"Agent.ForceToFollowPath", "agent: Agent, time: number 0.1..1000 [s] = 0.1, unused: value = nil", "Vector",
     "Steers back to the path, or ahead along it, if the agent would leave it or go backwards within this time.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
local force = agent:ForceToFollowPath(0.5) + agent:ForceToTargetSpeed(3))"},
    {"Agent.ForceToPosition", "agent: Agent, position: Vector [m]", "Vector", "A force straight towards a place.",
     R"(print(agent:ForceToPosition(Vector.new(3, 0.8, 0)).x)  --> 3)"},
    {"Agent.ForceToPursue", "agent: Agent, other: Agent, time: number [s] = 1", "Vector",
     "Heads for where the other agent will be, looking at most this time ahead.",
     R"(local force = agent:ForceToPursue(other))", true},
    {"Agent.ForceToSeparate",
     "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: table = everybody", "Vector",
     "A force away from the neighbours, stronger the nearer they are; ForceToAlign says which agents are neighbours.",
     R"(local force = agent:ForceToSeparate(2, 180, Sandbox.GetAgents(sandbox)))"},
    {"Agent.ForceToStayOnPath", "agent: Agent, time: number 0.1..1000 [s] = 0.1, unused: value = nil", "Vector",
     "Steers back to the path if the agent would leave it within this time.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
local force = agent:ForceToStayOnPath(0.5))"},
    {"Agent.ForceToTargetSpeed", "agent: Agent, speed: number [m/s]", "Vector",
     "A force forwards or backwards that brings the agent to this speed, limited to its greatest force.",
     R"(print(agent:ForceToTargetSpeed(3).z)  --> 3)"},
    {"Agent.ForceToWander", "agent: Agent, delta: number [ms]", "Vector",
     "A direction that changes at random. With 33, the time of a step, it jumps from side to side.",
     R"(local force = agent:ForceToWander(33))"},
    {"Agent.Push", "agent: Agent, force: Vector, time: number [s]", "",
     "Pushes the agent with its full strength during the next step, which lasts this long. The direction is that of "
     "the force along the ground (its y becomes 0). Also turns the agent to where it is about to move.",
     R"(agent:Push(agent:ForceToPosition(Vector.new(9, 0, 0)), 1 / 30)
print(agent:GetForward().x > 0.99)  --> true)",
     true},
    {"Agent.PushSmoothly", "agent: Agent, force: Vector, acceleration: Vector, time: number [s]", "",
     "Like Push, but smooth and by way of the velocity. Pass your own vector as the acceleration; it carries values "
     "from step to step.",
     R"(local acceleration = Vector.new()
agent:PushSmoothly(Vector.new(0, 0, 3), acceleration, 1 / 30)
print(acceleration.z > 0)  --> true)",
     true},
    {"Agent.WalkTo",
     "agent: Agent, position: Vector [m], time: number [s], lookAhead: number 0.1..1000 [s] = 1.5, weight: number = 3",
     "",
     "Walks towards a place for a step of this length, with the agent's full strength and at most its top speed, and "
     "avoids agents and movable objects in the way. The weight says how much avoiding counts against getting there.",
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
