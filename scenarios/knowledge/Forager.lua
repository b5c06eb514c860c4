-- SPDX-License-Identifier: BSD-2-Clause
-- Goes to the berries that its blackboard knows, and picks them. See Sandbox.lua.
require "AgentUtilities";
require "Blackboard";

local kSight = 10;
local kReach = 1.2;

local userData = { seen = {}, picked = 0 };
local board;

local function Nearest(agent, places)
    local nearest, best;
    for _, place in ipairs(places) do
        local distance = Vector.Distance(agent:GetPosition(), place);
        if (not best or distance < best) then
            nearest, best = place, distance;
        end
    end
    return nearest;
end

local function Sight(data)
    local nearest = Nearest(data.agent, data.seen);
    return { confidence = nearest and 0.9 or 0, evaluation = nearest };
end

local function Memory(data)
    return { confidence = data.remembered and 0.5 or 0, evaluation = data.remembered };
end

-- A place to look at; a new one every five seconds.
local function Rumor(data)
    return { confidence = 0.1, evaluation = Vector.new(math.random(-30, 30), 0.3, math.random(-30, 30)) };
end

local function OnEvent(sandbox, agent, type, event)
    if (type == "Bush") then
        if (Vector.Distance(agent:GetPosition(), event.position) < kSight) then
            table.insert(userData.seen, event.position);
        end
    elseif (type == "Picked" and event.agent == agent) then
        userData.picked = userData.picked + 1;
        print(agent:GetId() .. " picked " .. userData.picked);
    end
end

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(math.random(-20, 20), 0.8, math.random(-20, 20)));
    agent:SetMaxSpeed(4);
    userData.agent = agent;
    board = Blackboard.new(userData);
    board:AddSource("berries", KnowledgeSource.new(Rumor, 5000));
    board:AddSource("berries", KnowledgeSource.new(Memory));
    board:AddSource("berries", KnowledgeSource.new(Sight));
    Sandbox.AddEventCallback(agent:GetSandbox(), agent, OnEvent);
end

function Agent_Update(agent, deltaTimeInMillis)
    local place = board:Get("berries");
    local seen = Nearest(agent, userData.seen);
    -- Remembers the second bush in view, for the time after the first one is picked.
    for _, other in ipairs(userData.seen) do
        if (other ~= seen) then
            userData.remembered = other;
        end
    end
    if (Vector.Distance(agent:GetPosition(), place) < kReach) then
        Sandbox.AddEvent(agent:GetSandbox(), "Pick", { agent = agent, position = place });
        if (userData.remembered == place) then
            userData.remembered = nil;
        end
    end
    userData.seen = {};
    -- The bush that it remembered is no longer there.
    if (userData.remembered and Vector.Distance(agent:GetPosition(), userData.remembered) < kReach) then
        userData.remembered = nil;
    end

    AgentUtilities_ApplyPhysicsSteeringForce(agent, agent:ForceToPosition(place), deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
    Core.DrawLine(agent:GetPosition(), place, Vector.new(0, 0, 1));
end
