-- SPDX-License-Identifier: BSD-2-Clause
-- Helpers for agents that steer: turning a steering force into motion, keeping the speed in bounds, looks.

local kWeakForceSquared = 0.1;
local kSmoothing = 0.4;
local kTurnRate = 0.2;

local function HorizontalPart(vector)
    return Vector.new(vector.x, 0, vector.z);
end

-- Pushes the agent with all its strength along the horizontal part of `force`, and turns it to where that takes it.
-- The force's y becomes 0 in the caller's vector too.
function AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInSeconds)
    local mass = agent:GetMass();
    if (mass <= 0) then
        return;
    end

    force.y = 0;
    local push = Vector.Normalize(force) * agent:GetMaxForce();
    agent:ApplyForce(push);

    local heading = HorizontalPart(agent:GetVelocity() + push / mass * deltaTimeInSeconds);
    if (Vector.LengthSquared(heading) > 0) then
        agent:SetForward(Vector.Normalize(heading));
    end
end

-- The same by velocity instead of force: `accumulator` is a vector that the caller keeps from call to call and that
-- smooths the acceleration.
function AgentUtilities_ApplySteeringForce2(agent, force, accumulator, deltaTimeInSeconds)
    local mass = agent:GetMass();
    if (mass <= 0 or Vector.LengthSquared(force) < kWeakForceSquared) then
        return;
    end

    force.y = 0;
    local wanted = Vector.Normalize(force) * (agent:GetMaxForce() / mass);
    local acceleration = accumulator + (wanted - accumulator) * kSmoothing;
    accumulator.x = acceleration.x;
    accumulator.y = acceleration.y;
    accumulator.z = acceleration.z;

    local velocity = agent:GetVelocity() + acceleration * deltaTimeInSeconds;
    agent:SetVelocity(velocity);

    local heading = HorizontalPart(velocity);
    if (Vector.LengthSquared(velocity) > 0.1 and Vector.LengthSquared(heading) > 0) then
        local forward = agent:GetForward();
        agent:SetForward(forward + (Vector.Normalize(heading) - forward) * kTurnRate);
    end
end

-- Cuts the horizontal speed to the agent's maximum; falling and rising stay as they are.
function AgentUtilities_ClampHorizontalSpeed(agent)
    local velocity = agent:GetVelocity();
    local horizontal = HorizontalPart(velocity);
    local maxSpeed = agent:GetMaxSpeed();
    if (Vector.LengthSquared(horizontal) > maxSpeed * maxSpeed) then
        local clamped = Vector.Normalize(horizontal) * maxSpeed;
        clamped.y = velocity.y;
        agent:SetVelocity(clamped);
    end
end

-- Gives the agent the looks of an upright capsule.
function AgentUtilities_CreateAgentRepresentation(agent, height, radius)
    local capsule = Core.CreateCapsule(agent, height, radius);
    Core.SetMaterial(capsule, "Ground2");
    return capsule;
end

function AgentUtilities_DrawLineToTarget(agent)
    Core.DrawLine(agent:GetPosition(), agent:GetTarget(), Vector.new(0, 1, 0));
end

function AgentUtilities_DrawTargetRadius(agent)
    Core.DrawCircle(agent:GetTarget(), agent:GetTargetRadius(), Vector.new(1, 0, 0));
end

-- Moves an agent without a body along its velocity.
function AgentUtilities_UpdatePosition(agent, deltaTimeInSeconds)
    agent:SetPosition(agent:GetPosition() + agent:GetVelocity() * deltaTimeInSeconds);
end
