-- SPDX-License-Identifier: BSD-2-Clause
-- A yard with a guard and an intruder. The guard's script is what the scenarios of this folder differ in.
require "GUI";
require "SandboxUtilities";

function GuardWorld_Initialize(sandbox, guardScript)
    GUI_CreateUI(sandbox);
    Sandbox.SetCameraPosition(sandbox, Vector.new(0, 35, -35));
    Sandbox.SetCameraOrientation(sandbox, Vector.new(-135, 0, -180));
    SandboxUtilities_CreateLights(sandbox);
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 100, 100), "Ground2");
    Sandbox.CreateAgent(sandbox, "Intruder.lua");
    Sandbox.CreateAgent(sandbox, guardScript);
end

function Sandbox_Update(sandbox)
    GUI_UpdateUI(sandbox);
end

function Sandbox_HandleEvent(sandbox, event)
    GUI_HandleEvent(sandbox, event);
end
