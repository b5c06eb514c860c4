-- SPDX-License-Identifier: BSD-2-Clause
-- Runs along the path that the sandbox gave it, with a little straying.
require "AgentUtilities";
require "DebugUtilities";

local kSlowest = 3;

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(math.random(-50, 50), 0, math.random(-50, 50)));
end

function Agent_Update(agent, deltaTimeInMillis)
    local force = Vector.Normalize(agent:ForceToFollowPath(1.25))
        + Vector.Normalize(agent:ForceToStayOnPath(1)) * 0.25
        + agent:ForceToWander(deltaTimeInMillis) * 0.25;
    if (agent:GetSpeed() < kSlowest) then
        force = force + Vector.Normalize(agent:ForceToTargetSpeed(kSlowest));
    end
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
    DebugUtilities_DrawPath(agent:GetPath(), false, Vector.new(0, 0.02, 0));
end
