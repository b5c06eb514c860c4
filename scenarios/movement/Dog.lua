-- SPDX-License-Identifier: BSD-2-Clause
-- The dog: runs to where the courier is going to be. When it has caught the courier it trots back to its basket, has a
-- rest, and begins again.
require "AgentUtilities";

local kBasket = Vector.new(-10, 0.8, 8);
local kCaught = 1.4;
local kHome = 1;
local kRest_ms = 3000;
local kForesight = 1.2;

local courier, deed, rested;
catches = 0;

local function FindCourier(agent)
    local everybody = Sandbox.GetAgents(agent:GetSandbox());
    return everybody[1] ~= agent and everybody[1] or nil;
end

-- The activities: each function returns a force and the name of the next activity.
local deeds = {};

function deeds.hunt(agent)
    if (Vector.Distance(agent:GetPosition(), courier:GetPosition()) < kCaught) then
        catches = catches + 1;
        return Vector.new(), "trot";
    end
    Core.DrawLine(agent:GetPosition(), courier:PredictFuturePosition(kForesight), Vector.new(1, 0.4, 0));
    return agent:ForceToPursue(courier, kForesight), "hunt";
end

function deeds.trot(agent)
    if (Vector.Distance(agent:GetPosition(), kBasket) < kHome) then
        rested = 0;
        return Vector.new(), "rest";
    end
    return Vector.Normalize(agent:ForceToPosition(kBasket)) + agent:ForceToAvoidAgents(0.5) * 2, "trot";
end

function deeds.rest(agent, deltaTimeInMillis)
    rested = rested + deltaTimeInMillis;
    return agent:ForceToTargetSpeed(0), rested < kRest_ms and "rest" or "hunt";
end

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(kBasket);
    agent:SetMaxSpeed(6.6);
    deed = "hunt";
end

function Agent_Update(agent, deltaTimeInMillis)
    courier = courier or FindCourier(agent);
    if (courier) then
        local force;
        force, deed = deeds[deed](agent, deltaTimeInMillis);
        AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
        AgentUtilities_ClampHorizontalSpeed(agent);
    end
end
