-- SPDX-License-Identifier: BSD-2-Clause
-- Stands and turns, a full turn in eight seconds, and notices thieves.
require "AgentSenses";
require "AgentUtilities";
require "Blackboard";
require "DebugUtilities";

local kTurnMillis = 8000;

local userData = {};
local known = {};
local inView = {};

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetTeam("watch");
    userData.agent = agent;
    userData.blackboard = Blackboard.new(userData);
    AgentSenses_InitializeSenses(userData);
    AgentCommunications_AddEventCallback(userData, AgentCommunications.EventType.EnemySighted, function(data, type, message)
        local id = message.agent:GetId();
        if (not known[id]) then
            known[id] = true;
            print(data.agent:GetId() .. " knows of " .. id);
        end
    end);
end

function Agent_Update(agent, deltaTimeInMillis)
    local sandbox = agent:GetSandbox();
    local angle = 2 * math.pi * Sandbox.GetTimeInMillis(sandbox) / kTurnMillis;
    agent:SetForward(Vector.new(math.sin(angle), 0, math.cos(angle)));
    AgentSenses_UpdateSenses(sandbox, userData, deltaTimeInMillis);
    Core.DrawLine(agent:GetPosition(), agent:GetPosition() + agent:GetForward() * 5, DebugUtilities.White);
    for _, other in ipairs(Sandbox.GetAgents(sandbox)) do
        if (other:GetTeam() ~= agent:GetTeam()) then
            local seen = AgentSenses_CanSeeAgent(userData, other);
            if (seen and not inView[other:GetId()]) then
                print(agent:GetId() .. " sees " .. other:GetId());
            end
            inView[other:GetId()] = seen;
            Core.DrawLine(agent:GetPosition(), other:GetPosition(), seen and DebugUtilities.Green or DebugUtilities.Red);
        end
    end
end
