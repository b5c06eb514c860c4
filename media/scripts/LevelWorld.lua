-- SPDX-License-Identifier: BSD-2-Clause
-- Common parts of the scenarios on the level: the level, its navigation mesh "default", panels, camera and keys.
require "GUI";
require "SandboxUtilities";

local home, turn, meshIsShown;

local function ResetCamera(sandbox)
    Sandbox.SetCameraPosition(sandbox, home);
    Sandbox.SetCameraOrientation(sandbox, turn);
end

-- regionArea is the setting MinimumRegionArea of the mesh.
function LevelWorld_Initialize(sandbox, position, orientation, regionArea)
    home, turn, meshIsShown = position, orientation, false;
    GUI_CreateUI(sandbox);
    ResetCamera(sandbox);
    SandboxUtilities_CreateLevel(sandbox);
    Sandbox.CreateNavigationMesh(sandbox, "default", {
        WalkableRadius = 0.4, WalkableClimbHeight = 0.2, MinimumRegionArea = regionArea or 100 });
end

-- F1 camera, F3 navigation mesh, F5 performance, F6 camera panel, F7 bodies; Space shoots a block.
function LevelWorld_HandleEvent(sandbox, event)
    GUI_HandleEvent(sandbox, event);
    if (not event.pressed) then
        return;
    end
    if (event.key == "f1_key") then
        ResetCamera(sandbox);
    elseif (event.key == "f3_key") then
        meshIsShown = not meshIsShown;
        Sandbox.SetDebugNavigationMesh(sandbox, "default", meshIsShown);
    elseif (event.key == "space_key") then
        SandboxUtilities_ShootBox(sandbox);
    end
end

-- A random place of the mesh on the ground floor that can be reached from the middle of the level.
function LevelWorld_RandomPlace(sandbox)
    for _ = 1, 100 do
        local place = Sandbox.RandomPoint(sandbox, "default");
        if (place.y < 0.3 and place.y > -0.3 and #Sandbox.FindPath(sandbox, "default", Vector.new(), place) > 0) then
            return place;
        end
    end
    return Vector.new();
end

-- Puts an agent's feet on a place.
function LevelWorld_PutAgent(agent, place)
    agent:SetPosition(place + Vector.new(0, agent:GetHeight() / 2, 0));
    agent:SetTarget(place);
end
