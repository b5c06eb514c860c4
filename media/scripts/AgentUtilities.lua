-- SPDX-License-Identifier: BSD-2-Clause
-- From steering to motion: each of these functions is about one agent and one step.

-- Pushes with all of the agent's strength along the ground towards `force` (whose y is set to 0), and turns the agent to
-- where it is going to move.
function AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInSeconds)
    agent:Push(force, deltaTimeInSeconds);
end

-- Changes the velocity instead, smoothly: `accumulator` is a vector of the caller's that remembers the acceleration from
-- step to step.
function AgentUtilities_ApplySteeringForce2(agent, force, accumulator, deltaTimeInSeconds)
    agent:PushSmoothly(force, accumulator, deltaTimeInSeconds);
end

-- Nobody runs faster than their top speed; jumps and falls are let be.
function AgentUtilities_ClampHorizontalSpeed(agent)
    agent:ClampSpeed();
end

-- A capsule to look at, which the agent wears from now on.
function AgentUtilities_CreateAgentRepresentation(agent, height, radius)
    local body = Core.CreateCapsule(agent, height, radius);
    Core.SetMaterial(body, "Ground2");
    return body;
end

-- For this step: green from the agent to its target, red around the target.
function AgentUtilities_DrawLineToTarget(agent)
    Core.DrawLine(agent:GetTarget(), agent:GetPosition(), Vector.new(0, 1, 0));
end

function AgentUtilities_DrawTargetRadius(agent)
    Core.DrawCircle(agent:GetTarget(), agent:GetTargetRadius(), Vector.new(1, 0, 0));
end

-- What physics does for agents with a body: go on at the present velocity.
function AgentUtilities_UpdatePosition(agent, deltaTimeInSeconds)
    local way = agent:GetVelocity() * deltaTimeInSeconds;
    agent:SetPosition(way + agent:GetPosition());
end
