-- SPDX-License-Identifier: BSD-2-Clause
-- Common parts of the scenarios on open ground: a lit yard of 100 by 100 m, seen from above its edge, with panels.
require "GUI";
require "SandboxUtilities";

local kLookNorthAndDown = Vector.new(-135, 0, -180);

function YardWorld_Initialize(sandbox, cameraPosition)
    GUI_CreateUI(sandbox);
    Sandbox.SetCameraPosition(sandbox, cameraPosition);
    Sandbox.SetCameraOrientation(sandbox, kLookNorthAndDown);
    SandboxUtilities_CreateLights(sandbox);
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 100, 100), "Ground2");
end

function Sandbox_Update(sandbox)
    GUI_UpdateUI(sandbox);
end

function Sandbox_HandleEvent(sandbox, event)
    GUI_HandleEvent(sandbox, event);
end
