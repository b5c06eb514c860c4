-- SPDX-License-Identifier: BSD-2-Clause
-- Mind and body: soldiers that take commands. F4 drops a soldier; the keys 1 to 5 (or those of the number pad) tell all of
-- them to stand, shoot, move along the level's path, die, or change their stance.
require "GUI";
require "SandboxUtilities";

function Sandbox_Initialize(sandbox)
    GUI_CreateUI(sandbox);
    Sandbox.SetCameraPosition(sandbox, Vector.new(-17, 10, 0));
    Sandbox.SetCameraOrientation(sandbox, Vector.new(-145, -50, -150));
    SandboxUtilities_CreateLevel(sandbox);
end

function Sandbox_Update(sandbox)
    GUI_UpdateUI(sandbox);
end

function Sandbox_HandleEvent(sandbox, event)
    GUI_HandleEvent(sandbox, event);
    if (event.pressed and event.key == "f4_key") then
        local soldier = Sandbox.CreateAgent(sandbox, "CommandedSoldier.lua");
        soldier:SetPosition(Vector.new(math.random(-5, 5), soldier:GetHeight() / 2, math.random(0, 6)));
    end
end
