-- SPDX-License-Identifier: BSD-2-Clause
-- The default world of scenario files and of rules without a scenario: ground, sky, sun, and the usual keys.
require "GUI";
require "Plain";

local kCameraPosition = Vector.new(0, 32, 40);
local kCameraRotation = Vector.new(-40, 0, 0);

local function LookAtTheWorld(sandbox)
    Sandbox.SetCameraPosition(sandbox, kCameraPosition);
    Sandbox.SetCameraOrientation(sandbox, kCameraRotation);
end

function Sandbox_Initialize(sandbox)
    GUI_CreateUI(sandbox);
    LookAtTheWorld(sandbox);
    Plain_Create(sandbox);
end

function Sandbox_HandleEvent(sandbox, event)
    GUI_HandleEvent(sandbox, event);
    if (event.source == "keyboard" and event.pressed and event.key == "f1_key") then
        LookAtTheWorld(sandbox);
    end
end

function Sandbox_Update(sandbox, deltaTimeInMillis)
    GUI_UpdateUI(sandbox);
end
