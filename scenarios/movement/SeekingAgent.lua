-- SPDX-License-Identifier: BSD-2-Clause
-- An agent that its script alone drives: it runs to a target, avoids what is in its way, and picks the next target
-- when it has arrived.
require "AgentUtilities";

local kLookAhead = 1.5;
local kAvoidanceWeight = 3;
local kHalfSquare = 50;

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetTarget(Vector.new(kHalfSquare, 0, 0));
    agent:SetTargetRadius(1.5);
end

local function HasArrived(agent)
    local feet = agent:GetPosition();
    feet.y = feet.y - agent:GetHeight() / 2;
    return Vector.Distance(feet, agent:GetTarget()) < agent:GetTargetRadius() + agent:GetRadius();
end

function Agent_Update(agent, deltaTimeInMillis)
    local force = agent:ForceToPosition(agent:GetTarget()) +
        agent:ForceToAvoidAgents(kLookAhead) * kAvoidanceWeight +
        agent:ForceToAvoidObjects(kLookAhead) * kAvoidanceWeight;
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);

    if (HasArrived(agent)) then
        local target = agent:GetTarget();
        target.x = math.random(-kHalfSquare, kHalfSquare);
        target.z = math.random(-kHalfSquare, kHalfSquare);
        agent:SetTarget(target);
    end

    AgentUtilities_DrawTargetRadius(agent);
    AgentUtilities_DrawLineToTarget(agent);
    Core.DrawSquare(Vector.new(), 2 * kHalfSquare, Vector.new(1, 0, 0));
end
