-- SPDX-License-Identifier: BSD-2-Clause
-- A sheepdog: eight sheep in Lua flock and flee, a dog with a Soar mind gathers them and drives them through a gate into
-- their pen. Z lets them out again.
require "YardWorld";
require "Meadow";

local kSheep = 8;
local kFenceHeight = 1.1;

local sheep, dog = {}, nil;
local board, banner;
local kUpdateYard, kHandleYardEvent = Sandbox_Update, Sandbox_HandleEvent;
local hasWon = false;

-- A piece of fence from one place to another.
local function BuildFence(sandbox, fromX, fromZ, toX, toZ)
    local dx, dz = toX - fromX, toZ - fromZ;
    local length = math.sqrt(dx * dx + dz * dz);
    local rail = Sandbox.CreateBox(sandbox, 0.25, kFenceHeight, length + 0.25);
    Core.SetMaterial(rail, "Soarbox/Stone");
    Core.SetPosition(rail, Vector.new((fromX + toX) / 2, kFenceHeight / 2, (fromZ + toZ) / 2));
    Core.SetRotation(rail, Vector.new(0, math.deg(math.atan2(dx, dz)), 0));
    Core.SetMass(rail, 0);
end

-- The pen, and two wings that lead to its gate.
local function BuildPen(sandbox)
    local wide, gate, front, back = Meadow.PenHalfWidth, Meadow.GateHalfWidth, Meadow.PenBegin, Meadow.PenEnd;
    BuildFence(sandbox, -wide, front, -wide, back);
    BuildFence(sandbox, wide, front, wide, back);
    BuildFence(sandbox, -wide, back, wide, back);
    for _, side in ipairs({ -1, 1 }) do
        BuildFence(sandbox, side * gate, front, side * wide, front);
        BuildFence(sandbox, side * gate, front, side * (gate + 9), front - 9);
    end
end

local function Panel(sandbox, x, y, width, height, font)
    local panel = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetPosition(panel, x, y);
    UI.SetDimensions(panel, width, height);
    UI.SetTextMargin(panel, 10, 6);
    UI.SetFont(panel, font);
    UI.SetGradientColor(panel, "north_south", 0, 0, 0, 0.7, 0, 0, 0, 0.4);
    return panel;
end

-- Sheep begin anywhere on the meadow but near the pen and the dog.
local function PlaceSheep()
    for _, one in ipairs(sheep) do
        one:SetPosition(Vector.new(math.random(-24, 24), one:GetHeight() / 2, math.random(-16, 8)));
        one:SetVelocity(Vector.new());
    end
end

function Sandbox_Initialize(sandbox)
    YardWorld_Initialize(sandbox, Vector.new(0, 30, -46));
    Sandbox.SetCameraOrientation(sandbox, Vector.new(-145, 0, -180));
    BuildPen(sandbox);
    for number = 1, kSheep do
        sheep[number] = Sandbox.CreateAgent(sandbox, "Sheep.lua");
        sheep[number]:SetTeam("sheep");
    end
    PlaceSheep();
    dog = Sandbox.CreateSoarAgent(sandbox, "Dog.lua", "dog.soar", { name = "dog", team = "dog" });
    dog:SetPosition(Vector.new(0, dog:GetHeight() / 2, -24));
    board = Panel(sandbox, 20, 60, 220, 40, "medium");
end

local function Penned()
    local count = 0;
    for _, one in ipairs(sheep) do
        if (Meadow.IsInPen(one:GetPosition())) then
            count = count + 1;
        end
    end
    return count;
end

function Sandbox_Update(sandbox, deltaTimeInMillis)
    kUpdateYard(sandbox, deltaTimeInMillis);
    local penned = Penned();
    dog:SetScore(penned);
    UI.SetText(board, penned .. " of " .. #sheep .. " sheep in the pen");
    if (penned == #sheep and not hasWon) then
        hasWon = true;
        banner = Panel(sandbox, 20, 110, 420, 56, "large");
        UI.SetText(banner, "The pen is full. Z: again");
        Sandbox.End(sandbox, "all sheep are in the pen");
    end
end

function Sandbox_HandleEvent(sandbox, event)
    kHandleYardEvent(sandbox, event);
    if (event.source == "keyboard" and event.pressed and event.key == "z_key") then
        PlaceSheep();
        hasWon = false;
        if (banner) then
            UI.SetVisible(banner, false);
        end
    end
end
