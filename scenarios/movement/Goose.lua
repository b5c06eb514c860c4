-- SPDX-License-Identifier: BSD-2-Clause
-- A goose: stays near the courier and away from the other geese. When it is close enough, it stands still.
require "AgentUtilities";

local kClose, kFar = 3.5, 6;
local kElbowRoom = 1.6;

local courier, stands = nil, false;

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(math.random(-10, 10), agent:GetHeight() / 2, math.random(6, 16)));
    agent:SetMaxSpeed(6.4);
end

-- Stops when the courier is closer than kClose, and sets off again when the courier is farther than kFar.
local function Wish(agent, others)
    local gap = Vector.Distance(agent:GetPosition(), courier:GetPosition());
    if (gap < kClose) then
        stands = true;
    elseif (gap > kFar) then
        stands = false;
    end
    if (stands) then
        return agent:ForceToTargetSpeed(0);
    end
    local room = agent:ForceToSeparate(kElbowRoom, 180, others);
    return Vector.Normalize(agent:ForceToPosition(courier:GetPosition())) + room * 0.6;
end

function Agent_Update(agent, deltaTimeInMillis)
    local others = Sandbox.GetAgents(agent:GetSandbox());
    courier = courier or others[1];
    AgentUtilities_ApplyPhysicsSteeringForce(agent, Wish(agent, others), deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
end
