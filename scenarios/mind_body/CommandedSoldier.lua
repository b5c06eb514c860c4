-- SPDX-License-Identifier: BSD-2-Clause
-- A soldier whose mind are the keys: each queues a command for its controller.
require "DebugUtilities";
require "SandboxUtilities";
require "SoldierController";

local controller;
local last;
shots = 0;  -- That it heard, its own included.

local kCommands = {
    SoldierController.Commands.IDLE, SoldierController.Commands.SHOOT, SoldierController.Commands.MOVE,
    SoldierController.Commands.DIE, SoldierController.Commands.CHANGE_STANCE
};

function Agent_Initialize(agent)
    local soldier, weapon = Soldier_CreateLightSoldier(agent), Soldier_CreateWeapon(agent);
    controller = SoldierController.new(agent, soldier, weapon);
    Soldier_AttachWeapon(soldier, weapon);
    agent:SetMaxSpeed(Soldier.Speed.Stand);
    -- A path for the middle of the soldier.
    local path = SandboxUtilities_GetLevelPath();
    for _, point in ipairs(path) do
        point.y = point.y + agent:GetHeight() / 2;
    end
    agent:SetPath(path, true);
    Sandbox.AddEventCallback(agent:GetSandbox(), agent, function(_, self, type)
        if (type == AgentCommunications.EventType.BulletShot) then
            shots = shots + 1;
        end
    end);
end

function Agent_Update(agent, deltaTimeInMillis)
    controller:Update(agent, deltaTimeInMillis);
    if (controller:CurrentCommand() ~= last) then
        last = controller:CurrentCommand();
        print(agent:GetId() .. " " .. tostring(last));
    end
end

function Agent_HandleEvent(agent, event)
    if (event.source ~= "keyboard" or not event.pressed) then
        return;
    end
    for key, command in ipairs(kCommands) do
        if (string.find(event.key, "^[numpad_]*" .. key .. "_key$")) then
            if (command == SoldierController.Commands.DIE) then
                controller:ImmediateCommand(agent, command);
            else
                controller:QueueCommand(agent, command);
            end
        end
    end
end
