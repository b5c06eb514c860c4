-- SPDX-License-Identifier: BSD-2-Clause
-- An agent that its script alone drives: it flocks behind the first other agent of the sandbox.
require "AgentUtilities";

local kHalfSquare = 50;

local leader;

local function FindLeader(agent)
    for _, other in ipairs(Sandbox.GetAgents(agent:GetSandbox())) do
        if (other ~= agent) then
            return other;
        end
    end
end

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(
        math.random(-kHalfSquare, kHalfSquare), 0, math.random(-kHalfSquare, kHalfSquare)));
    leader = FindLeader(agent);
end

function Agent_Update(agent, deltaTimeInMillis)
    leader = leader or FindLeader(agent);
    if (not leader) then
        return;
    end
    local everybody = Sandbox.GetAgents(agent:GetSandbox());
    local force = agent:ForceToCombine(100, 180, { leader }) +
        agent:ForceToSeparate(2, 180, everybody) * 1.15 +
        agent:ForceToSeparate(5, 45, { leader });
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);

    Core.DrawCircle(agent:GetPosition(), 1, Vector.new(1, 1, 0));
    Core.DrawLine(agent:GetPosition(), leader:GetPosition(), Vector.new(0, 1, 0));
end
