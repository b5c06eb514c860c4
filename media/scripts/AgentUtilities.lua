-- SPDX-License-Identifier: BSD-2-Clause
-- Common functions of steered agents: applying forces, limiting the speed, a visible body, and lines that show where an
-- agent wants to go.

-- Forces whose squared length is below this are ignored.
local kFaint = 0.1;
-- Fractions of a new acceleration and of a new direction that are applied at once.
local kEagerness, kTurning = 0.4, 0.2;
local kSkin = "Ground2";
local kGreen, kRed = Vector.new(0, 1, 0), Vector.new(1, 0, 0);

local function IsFaint(vector)
    return Vector.LengthSquared(vector) < kFaint;
end

-- Makes a vector horizontal; changes its argument.
local function Level(vector)
    vector.y = 0;
    return vector;
end

-- The acceleration of an agent with its full force in a direction; nil if there is no force or no direction.
local function FullAcceleration(agent, direction)
    local mass = agent:GetMass();
    if (mass > 0 and not IsFaint(direction)) then
        return Vector.Normalize(Level(direction)) * (agent:GetMaxForce() / mass);
    end
end

-- Applies the agent's full force in the direction of `force` and turns the agent to its direction of movement. Makes
-- `force` horizontal.
function AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInSeconds)
    local acceleration = FullAcceleration(agent, force);
    if (acceleration) then
        agent:ApplyForce(Vector.Normalize(force) * agent:GetMaxForce());
        local heading = Level(agent:GetVelocity() + acceleration * deltaTimeInSeconds);
        agent:SetForward(Vector.Normalize(heading));
    end
end

-- The same by smoothly changing the velocity: `accumulator` is the acceleration of the previous call, which the caller
-- stores.
function AgentUtilities_ApplySteeringForce2(agent, force, accumulator, deltaTimeInSeconds)
    local wanted = FullAcceleration(agent, force);
    if (not wanted) then
        return;
    end
    local smooth = accumulator + (wanted - accumulator) * kEagerness;
    accumulator.x, accumulator.y, accumulator.z = smooth.x, smooth.y, smooth.z;
    local velocity = agent:GetVelocity() + smooth * deltaTimeInSeconds;
    agent:SetVelocity(velocity);
    if (not IsFaint(velocity)) then
        local heading = Vector.Normalize(Level(velocity));
        local forward = agent:GetForward();
        agent:SetForward(Vector.Normalize(forward + (heading - forward) * kTurning));
    end
end

-- Limits the horizontal speed to the agent's maximum; falling is not limited.
function AgentUtilities_ClampHorizontalSpeed(agent)
    local most, velocity = agent:GetMaxSpeed(), agent:GetVelocity();
    local speed = math.sqrt(velocity.x * velocity.x + velocity.z * velocity.z);
    if (speed > most) then
        velocity.x, velocity.z = velocity.x * most / speed, velocity.z * most / speed;
        agent:SetVelocity(velocity);
    end
end

-- Moves an agent that physics does not move.
function AgentUtilities_UpdatePosition(agent, deltaTimeInSeconds)
    agent:SetPosition(agent:GetPosition() + agent:GetVelocity() * deltaTimeInSeconds);
end

-- Creates a visible capsule; returns its node.
function AgentUtilities_CreateAgentRepresentation(agent, height, radius)
    local capsule = Core.CreateCapsule(agent, height, radius);
    Core.SetMaterial(capsule, kSkin);
    return capsule;
end

function AgentUtilities_DrawLineToTarget(agent)
    Core.DrawLine(agent:GetPosition(), agent:GetTarget(), kGreen);
end

function AgentUtilities_DrawTargetRadius(agent)
    Core.DrawCircle(agent:GetTarget(), agent:GetTargetRadius(), kRed);
end
