-- SPDX-License-Identifier: BSD-2-Clause
-- Messages between agents, based on the sandbox's events: to all agents, or to the sender's team. They arrive in the
-- next step.

AgentCommunications = { EventType = {} };
for _, name in ipairs({
    "AgentDeath", "AgentEnemySelection", "BulletImpact", "BulletShot", "DeadEnemySighted", "DeadFriendlySighted",
    "EnemySelection", "EnemySighted", "PositionUpdate", "RetreatPosition"
}) do
    AgentCommunications.EventType[name] = name;
end

-- By agent: the callbacks for each type of message.
local listeners = {};

local function IsMeantFor(agent, message)
    return not message.teamOnly or message.team == agent:GetTeam();
end

local function Listen(sandbox, agent)
    local functions = {};
    Sandbox.AddEventCallback(sandbox, agent, function(_, listener, type, message)
        if (functions[type] and IsMeantFor(listener, message)) then
            for _, heard in ipairs(functions[type]) do
                heard(type, message);
            end
        end
    end);
    return functions;
end

-- Calls callback(userData, type, message) for each message of this type that userData.agent receives.
function AgentCommunications_AddEventCallback(userData, type, callback)
    local agent = userData.agent;
    local id = agent:GetId();
    listeners[id] = listeners[id] or Listen(agent:GetSandbox(), agent);
    listeners[id][type] = listeners[id][type] or {};
    table.insert(listeners[id][type], function(heardType, message)
        callback(userData, heardType, message);
    end);
end

function AgentCommunications_SendMessage(sandbox, type, message)
    Sandbox.AddEvent(sandbox, type, message);
end

-- Sends it only to agents of the sender's team, including the sender. Adds the fields team and teamOnly to the message.
function AgentCommunications_SendTeamMessage(sandbox, agent, type, message)
    message.team = agent:GetTeam();
    message.teamOnly = true;
    AgentCommunications_SendMessage(sandbox, type, message);
end
