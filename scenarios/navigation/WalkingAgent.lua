-- SPDX-License-Identifier: BSD-2-Clause
-- Walks to a place of the navigation mesh, then to the next.
require "PathWalker";

local visits = 0;

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetMaxSpeed(3);
end

function Agent_Update(agent, deltaTimeInMillis)
    if (not agent:HasPath()) then
        if (PathWalker_HasArrived(agent) and visits > 0) then
            print("agent " .. agent:GetId() .. " has been at " .. visits .. " places");
        end
        -- If no path leads to the place, the next step tries another one.
        if (PathWalker_GoTo(agent, Sandbox.RandomPoint(agent:GetSandbox(), "default"))) then
            visits = visits + 1;
        end
    end
    PathWalker_Update(agent, deltaTimeInMillis);
end
