-- SPDX-License-Identifier: BSD-2-Clause
-- Given: the harbour. It is bright for 10 s, then dark for 10 s, and so on. Its percepts, and the way in which its commands
-- get here, is in lighthouse.lua.
require "SoarWorld";

Harbour = {};

local kTicksOfADay = 300;
local kTicksOfASecond = 30;
local ticks = 0;
local seconds_right, ticks_right = 0, 0;
local is_lit = false;
local lamp, beam, night;

local GroundAndSky = Sandbox_Initialize;
local UpdateWorld = Sandbox_Update;

local function Block(sandbox, width, height, length, x, y, z, material)
    local block = Sandbox.CreateBox(sandbox, width, height, length);
    Core.SetMass(block, 0);
    Core.SetPosition(block, Vector.new(x, y, z));
    Core.SetMaterial(block, material);
    return block;
end

-- Whether it is night.
function Harbour.IsDark()
    return math.floor(ticks / kTicksOfADay) % 2 == 1;
end

-- Whether the lamp is lit.
function Harbour.IsLit()
    return is_lit;
end

-- Lights the lamp (true), or puts it out (false).
function Harbour.SetLamp(on)
    is_lit = on;
    Core.SetMaterial(lamp, on and "Soarbox/Yellow" or "Soarbox/Rock");
    Core.SetVisible(beam, on);
end

function Sandbox_Initialize(sandbox)
    GroundAndSky(sandbox);
    Block(sandbox, 3, 6, 3, 0, 3, 0, "Soarbox/Rock");
    lamp = Block(sandbox, 1.6, 1.6, 1.6, 0, 6.8, 0, "Soarbox/Rock");
    Block(sandbox, 24, 0.6, 2, 0, 0.3, 8, "Soarbox/Rock");
    beam = Core.CreatePointLight(sandbox, Vector.new(0, 7, 3));
    Core.SetVisible(beam, false);
end

-- A point for each second in which the lamp is right: lit at night, out by day.
function Sandbox_Update(sandbox, milliseconds)
    UpdateWorld(sandbox, milliseconds);
    ticks = ticks + 1;
    if (is_lit == Harbour.IsDark()) then ticks_right = ticks_right + 1; end
    seconds_right = math.floor(ticks_right / kTicksOfASecond);
    for _, agent in ipairs(Sandbox.GetAgents(sandbox)) do agent:SetScore(seconds_right); end
end
