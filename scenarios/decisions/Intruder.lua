-- SPDX-License-Identifier: BSD-2-Clause
-- Walks about the yard; starts again from its edge when it is caught.
require "AgentUtilities";

local kEdge = 22;
local kInside = 14;

function Agent_Initialize(agent)
    Core.SetMaterial(AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius()), "Red");
    agent:SetMaxSpeed(2.5);
    agent:SetPosition(Vector.new(kEdge, 0.8, kEdge));
    agent:SetTarget(Vector.new(0, 0.8, 0));
    Sandbox.AddEventCallback(agent:GetSandbox(), agent, function(_, self, type)
        if (type == "Caught") then
            self:SetPosition(Vector.new(kEdge, 0.8, math.random(-kEdge, kEdge)));
        end
    end);
end

function Agent_Update(agent, deltaTimeInMillis)
    if (Vector.Distance(agent:GetPosition(), agent:GetTarget()) < 1) then
        agent:SetTarget(Vector.new(math.random(-kInside, kInside), 0.8, math.random(-kInside, kInside)));
    end
    local force = agent:ForceToPosition(agent:GetTarget());
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
end
