-- SPDX-License-Identifier: BSD-2-Clause
-- A drill: soldiers of two uniforms on the level, who do what the digits order (CommandedSoldier.lua). F4 calls another
-- soldier, F8 sends all of them home.
require "LevelWorld";

local kUniforms = { "dark", "light" };
local kMostSoldiers = 12;
local squad = {};

local function CallSoldier(sandbox)
    if (#squad >= kMostSoldiers) then
        print("the squad is complete");
        return;
    end
    local soldier = Sandbox.CreateAgent(sandbox, "CommandedSoldier.lua");
    squad[#squad + 1] = soldier;
    soldier:SetTeam(kUniforms[#squad % #kUniforms + 1]);
end

local onKey = { f4_key = CallSoldier };

function onKey.f8_key()
    for place, soldier in ipairs(squad) do
        soldier:SetPosition(Vector.new(2 * place, 1, -4));
    end
end

function Sandbox_Initialize(sandbox)
    LevelWorld_Initialize(sandbox, Vector.new(34, 26, -22), Vector.new(-142, 42, 155));
    print("F4 calls a soldier, F8 sends all home; 1 stand idle, 2 shoot, 3 walk, 4 die, 5 change the stance");
end

function Sandbox_Update(sandbox)
    GUI_UpdateUI(sandbox);
end

function Sandbox_HandleEvent(sandbox, event)
    LevelWorld_HandleEvent(sandbox, event);
    local act = event.pressed and onKey[event.key];
    if (act) then
        act(sandbox);
    end
end
