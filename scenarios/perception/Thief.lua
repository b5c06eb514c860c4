-- SPDX-License-Identifier: BSD-2-Clause
-- Walks to and fro along its side of the wall.
require "AgentUtilities";

function Agent_Initialize(agent)
    Core.SetMaterial(AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius()), "Red");
    agent:SetTeam("thieves");
    agent:SetMaxSpeed(3);
end

function Agent_Update(agent, deltaTimeInMillis)
    local target = agent:GetTarget();
    if (Vector.Distance(agent:GetPosition(), target) < 1) then
        target.z = -target.z;
        agent:SetTarget(target);
    end
    local force = agent:ForceToPosition(target);
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
end
