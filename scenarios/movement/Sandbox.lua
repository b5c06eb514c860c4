-- SPDX-License-Identifier: BSD-2-Clause
-- Steering on a common: a courier calls at four stalls, a dog chases it and rests after each catch, geese waddle behind
-- the courier, and joggers run laps around them all. Space drops a bale, which they avoid.
require "YardWorld";

local kStalls = { { -24, -18 }, { 26, -12 }, { 17, 24 }, { -20, 20 } };
local kGeese, kJoggers = 6, 12;
local kCorners = 16;
local kHandleYardEvent = Sandbox_HandleEvent;

-- An oval lap, as a list of places.
local function Lap(halfWidth, halfLength)
    local places = {};
    for corner = 1, kCorners do
        local angle = 2 * math.pi * corner / kCorners;
        places[corner] = Vector.new(halfWidth * math.cos(angle), 0, halfLength * math.sin(angle));
    end
    return places;
end

-- Seen from the middle, the counter is behind the customers' place, so nobody has to walk around it.
local function BuildStall(sandbox, x, z)
    local counter = Sandbox.CreateBox(sandbox, 2, 1, 2);
    local out = 1 + 3.5 / math.sqrt(x * x + z * z);
    Core.SetPosition(counter, Vector.new(x * out, 0.5, z * out));
end

function Sandbox_Initialize(sandbox)
    YardWorld_Initialize(sandbox, Vector.new(0, 36, 58));
    for _, stall in ipairs(kStalls) do
        BuildStall(sandbox, stall[1], stall[2]);
    end
    Sandbox.CreateAgent(sandbox, "Courier.lua");
    Sandbox.CreateAgent(sandbox, "Dog.lua");
    for _ = 1, kGeese do
        Sandbox.CreateAgent(sandbox, "Goose.lua");
    end
    for lane = 1, kJoggers do
        local jogger = Sandbox.CreateAgent(sandbox, "Jogger.lua");
        local lap = Lap(38 + lane % 3 * 2, 32 + lane % 3 * 2);
        jogger:SetPath(lap, true);
        jogger:SetPosition(lap[1 + lane * 5 % kCorners] + Vector.new(0, jogger:GetHeight() / 2, 0));
        jogger:SetMaxSpeed(4 + lane / 6);
    end
end

local function DropBale(sandbox)
    local bale = Sandbox.CreateBox(sandbox, 1.2, 1.2, 1.2);
    Core.SetPosition(bale, Vector.new(math.random(-15, 15), 6, math.random(-15, 15)));
    Core.SetMass(bale, 40);
end

function Sandbox_HandleEvent(sandbox, event)
    kHandleYardEvent(sandbox, event);
    if (event.pressed and event.key == "space_key") then
        DropBale(sandbox);
    end
end
