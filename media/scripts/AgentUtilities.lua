-- SPDX-License-Identifier: BSD-2-Clause
-- From steering to motion: each of these functions is about one agent and one step.

local Utilities = {
    weakest = 0.1,  -- The square of the length below which a steering direction says nothing.
    blend = 0.4,    -- The share of a new acceleration in the smoothed one.
    turn = 0.2      -- The share of the way to a new heading that one step turns.
};

local function OnGround(x, z)
    return Vector.new(x, 0, z);
end

-- The agent can be pushed, and the direction means something; flattens the caller's vector.
local function IsPush(agent, direction)
    if (agent:GetMass() <= 0 or Vector.LengthSquared(direction) < Utilities.weakest) then
        return false;
    end
    direction.y = 0;
    return Vector.LengthSquared(direction) > 0;
end

-- Pushes with all of the agent's strength along the ground towards `force` (whose y is set to 0), and turns the agent to
-- where it is going to move.
function AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInSeconds)
    if (agent:GetMass() <= 0) then
        return;
    end
    force.y = 0;
    local strength = Vector.Normalize(force) * agent:GetMaxForce();
    local next = agent:GetVelocity() + strength * (deltaTimeInSeconds / agent:GetMass());
    agent:ApplyForce(strength);
    agent:SetForward(OnGround(next.x, next.z));
end

-- Changes the velocity instead, smoothly: `accumulator` is a vector of the caller's that remembers the acceleration from
-- step to step.
function AgentUtilities_ApplySteeringForce2(agent, force, accumulator, deltaTimeInSeconds)
    if (not IsPush(agent, force)) then
        return;
    end
    local change = Vector.Normalize(force) * (agent:GetMaxForce() / agent:GetMass()) - accumulator;
    for _, axis in ipairs({ "x", "y", "z" }) do
        accumulator[axis] = accumulator[axis] + change[axis] * Utilities.blend;
    end
    agent:SetVelocity(agent:GetVelocity() + accumulator * deltaTimeInSeconds);

    local velocity = agent:GetVelocity();
    if (Vector.LengthSquared(velocity) > Utilities.weakest) then
        local facing = agent:GetForward() * (1 - Utilities.turn);
        agent:SetForward(facing + Vector.Normalize(OnGround(velocity.x, velocity.z)) * Utilities.turn);
    end
end

-- Nobody runs faster than their top speed; jumps and falls are let be.
function AgentUtilities_ClampHorizontalSpeed(agent)
    local velocity = agent:GetVelocity();
    local speed = math.sqrt(velocity.x * velocity.x + velocity.z * velocity.z);
    if (speed > agent:GetMaxSpeed()) then
        local factor = agent:GetMaxSpeed() / speed;
        agent:SetVelocity(Vector.new(velocity.x * factor, velocity.y, velocity.z * factor));
    end
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
