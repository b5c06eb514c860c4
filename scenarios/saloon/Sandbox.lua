-- SPDX-License-Identifier: BSD-2-Clause
-- A saloon with swing doors. Guests come, push the doors open, order at the bar and leave by the back door.
-- The doors hang on hinges. Two sensors notice guests that come in and go out. A guest that has left is removed, with
-- its script. The signs that greet guests are removed after a while.
require "YardWorld";

local kEvery = 1.2;          -- s between two guests.
local kMost = 12;            -- Guests at a time.
local kGreeting = 1.5;       -- s that a sign stays.
local kWallHeight = 3;

local inside, outside;       -- Sensors.
local board;
local signs = {};            -- { panel, untilTime } in the order of creation.
local present, served, nextGuest = 0, 0, 0;
local kUpdateYard = Sandbox_Update;

local function Wall(sandbox, x, z, width, length)
    local wall = Sandbox.CreateBox(sandbox, width, kWallHeight, length);
    Core.SetMaterial(wall, "Soarbox/Brick");
    Core.SetPosition(wall, Vector.new(x, kWallHeight / 2, z));
    Core.SetMass(wall, 0);
end

-- A leaf of the swing doors: `side` is -1 for the left one. It turns both ways about its post, with some friction.
local function DoorLeaf(sandbox, side)
    local leaf = Sandbox.CreateBox(sandbox, 1.2, 1.4, 0.08);
    Core.SetMaterial(leaf, "Soarbox/Crate");
    Core.SetPosition(leaf, Vector.new(side * 0.65, 1.1, 0));
    Core.SetMass(leaf, 4);
    Core.AddHinge(leaf, Vector.new(side * 1.25, 1.1, 0), Vector.new(0, 1, 0), nil, { low = -100, high = 100, friction = 4 });
end

local function Greet(sandbox, guest)
    local place = guest:GetPosition();
    local sign = Sandbox.CreateUIComponent3d(sandbox, Vector.new(place.x, 3.4, place.z));
    UI.SetDimensions(sign, 260, 60);
    UI.SetFont(sign, "large");
    UI.SetTextMargin(sign, 8, 12);
    UI.SetText(sign, "Welcome!");
    UI.SetWorldRotation(sign, Vector.new(0, 180, 0));
    table.insert(signs, { panel = sign, untilTime = Sandbox.GetTimeInSeconds(sandbox) + kGreeting });
end

local function HandleSensors(sandbox, _, type, event)
    if (type == "SensorEntered" and event.sensor == inside and event.agent) then
        present = present + 1;
        Greet(sandbox, event.agent);
    elseif (type == "SensorLeft" and event.sensor == inside and event.agent) then
        present = present - 1;
    elseif (type == "SensorEntered" and event.sensor == outside and event.agent) then
        served = served + 1;
        Sandbox.RemoveAgent(sandbox, event.agent);
    end
end

function Sandbox_Initialize(sandbox)
    YardWorld_Initialize(sandbox, Vector.new(0, 20, -22));
    Sandbox.SetCameraOrientation(sandbox, Vector.new(-140, 0, -180));
    Wall(sandbox, -5.65, 0, 8.7, 0.3);
    Wall(sandbox, 5.65, 0, 8.7, 0.3);
    Wall(sandbox, -10, 6, 0.3, 12);
    Wall(sandbox, 0, 12, 20, 0.3);
    Wall(sandbox, 10, 4, 0.3, 8);
    DoorLeaf(sandbox, -1);
    DoorLeaf(sandbox, 1);

    local bar = Sandbox.CreateBox(sandbox, 8, 1.1, 0.8);
    Core.SetMaterial(bar, "Soarbox/Crate");
    Core.SetPosition(bar, Vector.new(-3, 0.55, 10));
    Core.SetMass(bar, 0);

    inside = Sandbox.CreateSensor(sandbox, 19, 3, 10);
    Core.SetPosition(inside, Vector.new(0, 1.5, 6.6));
    outside = Sandbox.CreateSensor(sandbox, 2, 3, 6);
    Core.SetPosition(outside, Vector.new(15, 1.5, 10));
    Sandbox.AddEventCallback(sandbox, sandbox, HandleSensors);

    board = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetPosition(board, 20, 60);
    UI.SetDimensions(board, 380, 40);
    UI.SetTextMargin(board, 10, 6);
    UI.SetFont(board, "medium");
    UI.SetGradientColor(board, "north_south", 0, 0, 0, 0.7, 0, 0, 0, 0.4);
end

function Sandbox_Update(sandbox, deltaTimeInMillis)
    kUpdateYard(sandbox, deltaTimeInMillis);
    local now = Sandbox.GetTimeInSeconds(sandbox);
    if (now >= nextGuest and #Sandbox.GetAgents(sandbox) < kMost) then
        local guest = Sandbox.CreateAgent(sandbox, "Guest.lua");
        guest:SetPosition(Vector.new(math.random(-4, 4), guest:GetHeight() / 2, -14));
        nextGuest = now + kEvery;
    end
    while (signs[1] and now >= signs[1].untilTime) do
        UI.Remove(table.remove(signs, 1).panel);
    end
    UI.SetText(board, present .. " guests in the saloon, " .. served .. " served");
    if (served == 10) then
        Sandbox.End(sandbox, "ten guests served");
    end
end
