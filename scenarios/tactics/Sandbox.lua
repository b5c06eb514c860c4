-- SPDX-License-Identifier: BSD-2-Clause
-- Tactics: two teams of soldiers look for each other on the level, fight, flee when they are hurt, and report what they
-- see to their team. F4 shows the influence map: team1 blue, team2 red. F3 shows the navigation mesh.
require "LevelWorld";
require "SoldierTactics";

local kSoldiers = 6;
local kApart = 20;

local mapIsShown = false;

-- A place that is not near the chosen ones; after some attempts, any place.
local function FreePlace(sandbox, taken)
    local place;
    for _ = 1, 50 do
        place = LevelWorld_RandomPlace(sandbox);
        local isFree = true;
        for _, other in ipairs(taken) do
            isFree = isFree and Vector.Distance(place, other) >= kApart;
        end
        if (isFree) then
            break;
        end
    end
    table.insert(taken, place);
    return place;
end

function Sandbox_Initialize(sandbox)
    LevelWorld_Initialize(sandbox, Vector.new(-26, 52, -22), Vector.new(-113, -25, -135), 250);
    local taken = {};
    for _ = 1, kSoldiers do
        LevelWorld_PutAgent(Sandbox.CreateAgent(sandbox, "TacticalSoldier.lua"), FreePlace(sandbox, taken));
    end
    SoldierTactics_InitializeTactics(sandbox);
    -- The map would hide the soldiers.
    Sandbox.SetDrawInfluenceMap(sandbox, mapIsShown);
end

function Sandbox_Update(sandbox, deltaTimeInMillis)
    GUI_UpdateUI(sandbox);
    SoldierTactics_UpdateTactics(sandbox, deltaTimeInMillis);
end

function Sandbox_HandleEvent(sandbox, event)
    LevelWorld_HandleEvent(sandbox, event);
    if (event.pressed and event.key == "f4_key") then
        mapIsShown = not mapIsShown;
        Sandbox.SetDrawInfluenceMap(sandbox, mapIsShown);
    end
end
