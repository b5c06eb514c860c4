-- SPDX-License-Identifier: BSD-2-Clause
-- The courier: runs from stall to stall in a new random order each round, and waits a moment at each.
require "AgentUtilities";

local kStalls = { { -24, -18 }, { 26, -12 }, { 17, 24 }, { -20, 20 } };
local kNearEnough = 1.5;
local kWait_ms = 800;
local kBend = 2;

local round, waits = {}, 0;
calls = 0;

local function DrawRound()
    local left = { 1, 2, 3, 4 };
    while (#left > 0) do
        round[#round + 1] = table.remove(left, math.random(#left));
    end
end

local function GoOn(agent)
    if (#round == 0) then
        DrawRound();
    end
    local stall = kStalls[table.remove(round, 1)];
    agent:SetTarget(Vector.new(stall[1], 0, stall[2]));
end

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(0, agent:GetHeight() / 2, 0));
    agent:SetMaxSpeed(6);
    GoOn(agent);
end

local function GroundDistance(a, b)
    return math.sqrt((a.x - b.x) ^ 2 + (a.z - b.z) ^ 2);
end

function Agent_Update(agent, deltaTimeInMillis)
    local seconds = deltaTimeInMillis / 1000;
    if (waits > 0) then
        waits = waits - deltaTimeInMillis;
        AgentUtilities_ApplyPhysicsSteeringForce(agent, agent:ForceToTargetSpeed(0), seconds);
        if (waits <= 0) then
            GoOn(agent);
        end
        return;
    end
    local force = Vector.Normalize(agent:ForceToPosition(agent:GetTarget()))
        + (agent:ForceToAvoidObjects(1) + agent:ForceToAvoidAgents(0.5)) * kBend;
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, seconds);
    AgentUtilities_ClampHorizontalSpeed(agent);
    if (GroundDistance(agent:GetPosition(), agent:GetTarget()) < kNearEnough) then
        calls, waits = calls + 1, kWait_ms;
    end
    AgentUtilities_DrawLineToTarget(agent);
end
