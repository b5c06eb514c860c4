-- SPDX-License-Identifier: BSD-2-Clause
-- Steering: a seeker, a pursuer that hunts it, followers that flock behind it, and runners on a path. Space shoots a block
-- that they get out of the way of, F1 resets the camera.
require "DebugUtilities";
require "GUI";
require "SandboxUtilities";

local kPath = {
    Vector.new(0, 0, 0), Vector.new(30, 0, 0), Vector.new(30, 0, 50), Vector.new(-30, 0, 0), Vector.new(-30, 0, 20)
};

local function ResetCamera(sandbox)
    Sandbox.SetCameraPosition(sandbox, Vector.new(-30, 5, 7));
    Sandbox.SetCameraOrientation(sandbox, Vector.new(-131, -68, -133));
end

function Sandbox_Initialize(sandbox)
    GUI_CreateUI(sandbox);
    ResetCamera(sandbox);
    SandboxUtilities_CreateLights(sandbox);
    Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0));
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 200, 200), "Ground2");

    Sandbox.CreateAgent(sandbox, "SeekingAgent.lua");
    Sandbox.CreateAgent(sandbox, "PursuingAgent.lua");
    for _ = 1, 5 do
        Sandbox.CreateAgent(sandbox, "FollowerAgent.lua");
    end
    for _ = 1, 20 do
        local runner = Sandbox.CreateAgent(sandbox, "PathingAgent.lua");
        runner:SetPath(kPath, true);
        runner:SetMaxSpeed(math.random(runner:GetMaxSpeed() * 0.85, runner:GetMaxSpeed() * 1.15));
    end
end

function Sandbox_Update(sandbox)
    GUI_UpdateUI(sandbox);
    DebugUtilities_DrawDynamicBoundingSpheres(Sandbox.GetObjects(sandbox));
end

function Sandbox_HandleEvent(sandbox, event)
    GUI_HandleEvent(sandbox, event);
    if (event.pressed and event.key == "space_key") then
        SandboxUtilities_ShootBox(sandbox);
    elseif (event.pressed and event.key == "f1_key") then
        ResetCamera(sandbox);
    end
end
