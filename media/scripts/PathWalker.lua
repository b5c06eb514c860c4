-- SPDX-License-Identifier: BSD-2-Clause
-- Walking on the navigation mesh "default": finds paths and follows them.
require "AgentUtilities";
require "DebugUtilities";

local kMesh = "default";
local kArrival = 1;

local function Feet(agent)
    return agent:GetPosition() - Vector.new(0, agent:GetHeight() / 2, 0);
end

-- Starts to walk to a place; false if there is no path.
function PathWalker_GoTo(agent, place)
    local path = Sandbox.FindPath(agent:GetSandbox(), kMesh, Feet(agent), place);
    if (#path == 0) then
        return false;
    end
    -- The path of the agent's centre.
    for _, point in ipairs(path) do
        point.y = point.y + agent:GetHeight() / 2;
    end
    agent:SetPath(path, false);
    agent:SetTarget(place);
    return true;
end

function PathWalker_HasArrived(agent)
    return Vector.Distance(Feet(agent), agent:GetTarget()) < kArrival;
end

-- One step along the path; without a path the agent stops.
function PathWalker_Update(agent, deltaTimeInMillis)
    if (not agent:HasPath()) then
        local velocity = agent:GetVelocity();
        agent:SetVelocity(Vector.new(velocity.x * 0.8, velocity.y, velocity.z * 0.8));
        return;
    end
    local force = agent:ForceToFollowPath(0.5) * 1.5 + agent:ForceToStayOnPath(0.5) * 0.5
        + agent:ForceToAvoidAgents(0.5);
    if (agent:GetSpeed() < agent:GetMaxSpeed()) then
        force = force + agent:ForceToTargetSpeed(agent:GetMaxSpeed()) * 5;
    end
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
    DebugUtilities_DrawPath(agent:GetPath(), false, Vector.new(0, -0.7, 0), DebugUtilities.Orange);
    if (PathWalker_HasArrived(agent)) then
        agent:RemovePath();
    end
end
