-- SPDX-License-Identifier: BSD-2-Clause
-- A rover collects crystals before its battery is empty. Models, an image and sounds come from files of this folder
-- (make_files.py writes them); the panels have buttons and a bar; arrow keys, a gamepad or the autopilot drive.
require "SandboxUtilities";

local kCrystals, kField = 9, 20;
local kSeconds = 45; -- What a full battery lasts; a crystal gives a third of it.

local rover;
local crystals = {};
local battery, score, runs, autopilot = 1, 0, false, true;
local energy, count, start, mode, message;

local function Panel(sandbox, x, y, width, height, font, text)
    local panel = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetPosition(panel, x, y);
    UI.SetDimensions(panel, width, height);
    UI.SetFont(panel, font);
    UI.SetTextMargin(panel, 8, 12);
    UI.SetGradientColor(panel, "north_south", 0.05, 0.08, 0.14, 0.85, 0.05, 0.08, 0.14, 0.65);
    UI.SetText(panel, text);
    return panel;
end

local function PlaceCrystal(node)
    Core.SetPosition(node, Vector.new(math.random(-kField, kField), 0.1, math.random(-kField, kField)));
end

local function Nearest()
    local best, bestDistance = nil, math.huge;
    for _, crystal in ipairs(crystals) do
        local distance = Vector.Distance(Core.GetPosition(crystal), rover:GetPosition());
        if (distance < bestDistance) then best, bestDistance = crystal, distance; end
    end
    return best, bestDistance;
end

local function TellRover(sandbox)
    Sandbox.AddEvent(sandbox, "Run", { runs = runs and 1 or 0 });
    if (autopilot) then
        Sandbox.AddEvent(sandbox, "Goal", { position = Core.GetPosition((Nearest())) });
    else
        Sandbox.AddEvent(sandbox, "Manual", {});
    end
end

local function Show()
    UI.SetBar(energy, battery, battery < 0.25 and 0.85 or 0.2, battery < 0.25 and 0.25 or 0.65, 0.25);
    UI.SetText(energy, string.format("Battery %d %%", math.ceil(battery * 100)));
    UI.SetText(count, tostring(score));
    UI.SetText(start, runs and "Stop" or (battery > 0 and "Start" or "Again"));
    UI.SetText(mode, autopilot and "Autopilot" or "By hand");
    UI.SetVisible(message, not runs);
end

local function PressStart(sandbox)
    Sandbox.PlaySound(sandbox, "click.wav", 0.7);
    if (not runs and battery <= 0) then battery, score = 1, 0; end
    runs = not runs;
    TellRover(sandbox);
    Show();
end

local function PressMode(sandbox)
    Sandbox.PlaySound(sandbox, "click.wav", 0.7);
    autopilot = not autopilot;
    TellRover(sandbox);
    Show();
end

function Sandbox_Initialize(sandbox)
    Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0));
    SandboxUtilities_CreateLights(sandbox);
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 200, 200), "Ground");
    Sandbox.SetCameraPosition(sandbox, Vector.new(0, 16, -26));
    Sandbox.SetCameraOrientation(sandbox, Vector.new(-148, 0, -180));
    for number = 1, kCrystals do
        crystals[number] = Core.CreateMesh(sandbox, "crystal.glb");
        PlaceCrystal(crystals[number]);
    end
    rover = Sandbox.CreateAgent(sandbox, "Rover.lua");
    energy = Panel(sandbox, 20, 20, 260, 40, "medium", "");
    local badge = Panel(sandbox, 20, 70, 64, 64, "medium", "");
    UI.SetBackgroundColor(badge, 0, 0, 0, 0);
    UI.SetImage(badge, "badge.png");
    count = Panel(sandbox, 94, 78, 80, 50, "large", "");
    start = Panel(sandbox, 20, 146, 125, 40, "medium", "");
    UI.SetButton(start, "start", PressStart);
    mode = Panel(sandbox, 155, 146, 125, 40, "medium", "");
    UI.SetButton(mode, "autopilot", PressMode);
    message = Panel(sandbox, 20, 196, 260, 66, "small",
        "Collect the crystals before the battery is empty. The autopilot drives; by hand it is arrow keys or a gamepad.");
    Show();
end

function Sandbox_HandleEvent(sandbox, event)
    if (event.source == "gamepad" and event.button == "start_button" and event.pressed) then PressStart(sandbox); end
end

function Sandbox_Update(sandbox, milliseconds)
    for number, crystal in ipairs(crystals) do
        Core.SetRotation(crystal, Vector.new(0, (Sandbox.GetTimeInMillis(sandbox) / 15 + 40 * number) % 360, 0));
    end
    if (not runs) then return; end
    battery = math.max(0, battery - milliseconds / 1000 / kSeconds);
    local crystal, distance = Nearest();
    if (distance < 1.4) then
        Sandbox.PlaySound(sandbox, "chime.wav", 1, Core.GetPosition(crystal));
        PlaceCrystal(crystal);
        score = score + 1;
        battery = math.min(1, battery + 1 / 3);
        TellRover(sandbox);
    end
    if (battery == 0) then
        runs = false;
        TellRover(sandbox);
    end
    Show();
end
