-- SPDX-License-Identifier: BSD-2-Clause
-- Ponies on a meadow: a model from a file with a skin and animations (make_pony.py writes it). The button calls them.
require "SandboxUtilities";

local kPonies = 4;

local function Whistle(sandbox)
    Sandbox.AddEvent(sandbox, "Whistle", { position = Vector.new(0, 0, 0) });
end

function Sandbox_Initialize(sandbox)
    Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0));
    SandboxUtilities_CreateLights(sandbox);
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 200, 200), "Ground");
    for number = 1, kPonies do Sandbox.CreateAgent(sandbox, "Pony.lua"); end
    local whistle = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetPosition(whistle, 20, 20);
    UI.SetDimensions(whistle, 125, 40);
    UI.SetFont(whistle, "medium");
    UI.SetTextMargin(whistle, 8, 12);
    UI.SetGradientColor(whistle, "north_south", 0.05, 0.08, 0.14, 0.85, 0.05, 0.08, 0.14, 0.65);
    UI.SetText(whistle, "Whistle");
    UI.SetButton(whistle, "whistle", Whistle);
end
