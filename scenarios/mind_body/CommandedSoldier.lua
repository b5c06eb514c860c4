-- SPDX-License-Identifier: BSD-2-Clause
-- A soldier without a mind: the user is its mind. A digit, on the keypad or above the letters, is an order for all
-- soldiers: 1 stand idle, 2 shoot, 3 walk the level's path, 4 die, 5 change the stance. It prints what it begins to do.
require "AgentCommunications";
require "SandboxUtilities";
require "SoldierController";

local kOrders = {
    ["1"] = "IDLE", ["2"] = "SHOOT", ["3"] = "MOVE", ["4"] = "DIE", ["5"] = "CHANGE_STANCE"
};

local body, deed;
local fallen = false;
shots = 0;  -- Shots that it has heard, including its own.

local function Dress(agent)
    local weapon = Soldier_CreateWeapon(agent);
    local soldier = agent:GetId() % 2 == 0 and Soldier_CreateLightSoldier(agent) or Soldier_CreateSoldier(agent);
    body = SoldierController.new(agent, soldier, weapon);
    Soldier_AttachWeapon(soldier, weapon);
end

local function HearShots(agent)
    AgentCommunications_AddEventCallback({ agent = agent }, AgentCommunications.EventType.BulletShot, function()
        shots = shots + 1;
    end);
end

function Agent_Initialize(agent)
    local path = SandboxUtilities_GetLevelPath();
    agent:SetMaxSpeed(Soldier.Speed.Stand);
    agent:SetPosition(path[1] + Vector.new(0, agent:GetHeight() / 2, 0));
    Soldier_SetPath(agent, path, true);
    Dress(agent);
    HearShots(agent);
end

-- A soldier that was hit too often falls, whatever its order is.
local function FallIfDead(agent)
    if (not fallen and agent:GetHealth() <= 0) then
        fallen = true;
        body:ClearCommands();
        body:QueueCommand(agent, kOrders["4"]);
    end
end

function Agent_Update(agent, deltaTimeInMillis)
    FallIfDead(agent);
    body:Update(agent, deltaTimeInMillis);
    local now = body:CurrentCommand();
    if (now and now ~= deed) then
        deed = now;
        print(agent:GetId() .. " " .. deed);
    end
end

local function Digit(key)
    return key and (key:match("^(%d)_key$") or key:match("^numpad_(%d)_key$")) or "";
end

function Agent_HandleEvent(agent, event)
    local order = event.pressed and kOrders[Digit(event.key)];
    if (not order or agent:GetHealth() <= 0) then
        return;
    end
    body:ClearCommands();
    body:QueueCommand(agent, order);
end
