-- SPDX-License-Identifier: BSD-2-Clause
-- Sight and hearing of an agent. Noticed things are stored in its blackboard: visibleAgents, deadEnemies and
-- deadFriendlies by the number of the agent ({agent, seenAt, lastSeen}), bulletShots and bulletImpacts as lists
-- ({position, time}). Sightings are sent to the team.
require "AgentCommunications";
require "DebugUtilities";

local kHalfViewCosine = math.cos(math.rad(45));
local kEyeAhead = 0.5;
local kTellAgainMillis = 500;
local kSoundMillis = 1000;
local kHead = "b_Head1";

local Events = AgentCommunications.EventType;

local function Remember(name)
    return function(userData, type, message)
        local sight = { agent = message.agent, seenAt = message.seenAt, lastSeen = message.lastSeen };
        if (not sight.agent) then
            return;
        end
        local id = sight.agent:GetId();
        userData.blackboard:Get(name)[id] = sight;
        if (name ~= "visibleAgents") then
            userData.blackboard:Get("visibleAgents")[id] = nil;
        end
    end;
end

local function Hear(name)
    return function(userData, type, message)
        local now = Sandbox.GetTimeInMillis(userData.agent:GetSandbox());
        table.insert(userData.blackboard:Get(name), { position = message.position, time = now });
    end;
end

-- userData contains agent and blackboard, and soldier: the mesh with the head. Without a mesh, the agent's centre is
-- used.
function AgentSenses_InitializeSenses(userData)
    local listeners = {
        [Events.EnemySighted] = { "visibleAgents", Remember },
        [Events.DeadEnemySighted] = { "deadEnemies", Remember },
        [Events.DeadFriendlySighted] = { "deadFriendlies", Remember },
        [Events.BulletShot] = { "bulletShots", Hear },
        [Events.BulletImpact] = { "bulletImpacts", Hear }
    };
    for type, listener in pairs(listeners) do
        userData.blackboard:Set(listener[1], {});
        AgentCommunications_AddEventCallback(userData, type, listener[2](listener[1]));
    end
end

-- The position of the eyes, and the direction of view.
local function Eyes(userData)
    if (not userData.soldier) then
        return userData.agent:GetPosition(), userData.agent:GetForward();
    end
    local rotation = Animation.GetBoneRotation(userData.soldier, kHead);
    return Animation.GetBonePosition(userData.soldier, kHead), Vector.Rotate(Vector.new(0, 0, -1), rotation);
end

-- True if the other agent is in the field of view and nothing hides it. `draw` shows the line of sight for this step:
-- green if it is seen, red if something hides it.
function AgentSenses_CanSeeAgent(userData, other, draw)
    local eye, forward = Eyes(userData);
    local toward = Vector.Normalize(other:GetPosition() - eye);
    if (Vector.DotProduct(forward, toward) < kHalfViewCosine) then
        return false;
    end
    local from = eye + forward * kEyeAhead;
    local hit = Sandbox.RayCastToObject(userData.agent:GetSandbox(), from, other:GetPosition());
    local sees = not hit.result or (Agent.IsAgent(hit.object) and hit.object == other);
    if (draw) then
        Core.DrawLine(from, other:GetPosition(), sees and DebugUtilities.Green or DebugUtilities.Red);
    end
    return sees;
end

-- The type of a sighting, and the table that stores it; nil for living friends.
local function Kind(agent, other)
    if (other:GetTeam() == agent:GetTeam()) then
        if (other:GetHealth() > 0) then
            return nil, "visibleAgents";
        end
        return Events.DeadFriendlySighted, "deadFriendlies";
    end
    if (other:GetHealth() > 0) then
        return Events.EnemySighted, "visibleAgents";
    end
    return Events.DeadEnemySighted, "deadEnemies";
end

local function Notice(userData, other, now)
    local event, name = Kind(userData.agent, other);
    local known = userData.blackboard:Get(name);
    local before = known[other:GetId()];
    local sight = { agent = other, seenAt = other:GetPosition(), lastSeen = now };
    if (event and (not before or now - before.lastSeen > kTellAgainMillis)) then
        AgentCommunications_SendTeamMessage(userData.agent:GetSandbox(), userData.agent, event, {
            agent = other, seenAt = sight.seenAt, lastSeen = now });
    end
    known[other:GetId()] = sight;
end

local function Forget(sounds, now)
    for index = #sounds, 1, -1 do
        if (now - sounds[index].time > kSoundMillis) then
            table.remove(sounds, index);
        end
    end
end

-- Call it once per step of the agent.
function AgentSenses_UpdateSenses(sandbox, userData, deltaTimeInMillis)
    local now = Sandbox.GetTimeInMillis(sandbox);
    Forget(userData.blackboard:Get("bulletShots"), now);
    Forget(userData.blackboard:Get("bulletImpacts"), now);
    for _, other in ipairs(Sandbox.GetAgents(sandbox)) do
        if (other ~= userData.agent and AgentSenses_CanSeeAgent(userData, other)) then
            Notice(userData, other, now);
        end
    end
end
