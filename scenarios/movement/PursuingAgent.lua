-- SPDX-License-Identifier: BSD-2-Clause
-- Runs to where the first other agent will be in a second, a little slower than that one can run.
require "AgentUtilities";

local quarry;

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(math.random(-50, 50), 0, math.random(-50, 50)));
    agent:SetTargetRadius(1);
    quarry = Sandbox.GetAgents(agent:GetSandbox())[1];
    agent:SetMaxSpeed(quarry:GetMaxSpeed() * 0.8);
end

function Agent_Update(agent, deltaTimeInMillis)
    agent:SetTarget(quarry:PredictFuturePosition(1));
    local force = agent:ForceToPosition(agent:GetTarget());
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
    AgentUtilities_DrawTargetRadius(agent);
    AgentUtilities_DrawLineToTarget(agent);
end
