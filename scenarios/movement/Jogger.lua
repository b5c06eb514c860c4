-- SPDX-License-Identifier: BSD-2-Clause
-- A jogger: runs laps on the path that the sandbox gave it, and makes room for those in front.
require "AgentUtilities";

local kLookAhead = 0.9;
local kCourtesy = 1.5;

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
end

function Agent_Update(agent, deltaTimeInMillis)
    local force = Vector.Normalize(agent:ForceToFollowPath(kLookAhead)) + agent:ForceToAvoidAgents(kLookAhead) * kCourtesy
        + Vector.Normalize(agent:ForceToTargetSpeed(agent:GetMaxSpeed()));
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
end
