-- SPDX-License-Identifier: BSD-2-Clause
-- The visible world of TankSoar: the board, the tanks and the missiles of TankSoarRules.lua. A scenario uses this
-- script, or its own script, which sets TankSoar.Settings first, as with Eaters.lua.
require "GridGame";
require "MapFile";
require "TankSoarRules";

TankSoar = { Settings = {} };

local kMissileUp = 0.75;
local kRadarColor = Vector.new(0.95, 0.85, 0.25);
local game, grid;
local tanks = {};     -- By agent id: the tank, its agent, its shield.
local missiles = {};  -- By number: node, where it flies from and to.
local packs = {};     -- Node by place.
local blasts = {};    -- Places where something explodes in this turn.

-- The board -----------------------------------------------------------------------------------------------------------

local function Charger(x, y, material)
    grid:PutBox(x, y, Vector.new(1.3, 0.14, 1.3), "Soarbox/Metal");
    local pole = Core.CreateCylinder(grid.sandbox, 0.5, 0.34);
    grid:Put(pole, x, y, 0.2, material);
end

local function ShowObstacle(x, y)
    grid:PutBox(x, y, Vector.new(1.44, 0.7, 1.44), "Soarbox/Rock");
    grid:PutBox(x, y, Vector.new(1.1, 1.15, 1.1), "Soarbox/Hedge");
end

local function BuildCells()
    for y = 1, game.height do
        for x = 1, game.width do
            local content = game:ContentAt(x, y);
            if (content == "obstacle") then
                ShowObstacle(x, y);
            elseif (content == "health") then
                Charger(x, y, "RedGlow");
            elseif (content == "energy") then
                Charger(x, y, "BlueGlow");
            end
        end
    end
end

local function ShowPacks()
    for y = 1, game.height do
        for x = 1, game.width do
            local name, isThere = y * 1000 + x, game.cells[y][x] == "missiles";
            if (isThere and not packs[name]) then
                packs[name] = grid:PutBox(x, y, Vector.new(0.7, 0.4, 0.5), "Soarbox/Ammunition", 0.05);
            elseif (packs[name] and not isThere) then
                Core.Remove(packs[name]);
                packs[name] = nil;
            end
        end
    end
end

-- Tanks ---------------------------------------------------------------------------------------------------------------

local function Part(parent, node, place, material)
    Core.SetPosition(node, place);
    Core.SetMaterial(node, material);
    return node;
end

-- Hull, tracks, turret and gun, and a shield that is visible while it is up.
local function Dress(agent, color)
    local material = GridGame.Materials[color];
    Part(agent, Core.CreateBox(agent, 0.86, 0.3, 1.1), Vector.new(0, -0.42, 0), material);
    for _, side in ipairs({ -1, 1 }) do
        Part(agent, Core.CreateBox(agent, 0.24, 0.34, 1.24), Vector.new(side * 0.5, -0.5, 0), "Soarbox/Black");
    end
    Part(agent, Core.CreateCylinder(agent, 0.28, 0.34), Vector.new(0, -0.16, -0.08), material);
    Part(agent, Core.CreateBox(agent, 0.12, 0.12, 0.8), Vector.new(0, -0.12, 0.5), "Soarbox/Metal");
    local shield = Part(agent, Core.CreateCapsule(agent, 1.7, 0.85), Vector.new(0, -0.2, 0), "TransparentBlue");
    Core.SetVisible(shield, false);
    local scorch = Part(agent, Core.CreateBox(agent, 0.6, 0.06, 0.4), Vector.new(0.1, -0.26, -0.38), "Soarbox/Black");
    Core.SetVisible(scorch, false);
    local fire = Part(agent, Core.CreateCapsule(agent, 0.3, 0.1), Vector.new(-0.14, 0.05, -0.3), "RedGlow");
    Core.SetVisible(fire, false);
    return shield, scorch, fire;
end

local function Begin(sandbox)
    if (next(tanks)) then
        return;
    end
    for i, agent in ipairs(Sandbox.GetAgents(sandbox)) do
        local color = GridGame.Colors[(i - 1) % #GridGame.Colors + 1];
        local tank = game:Join(color);
        agent:SetTeam(color);
        agent:SetScore(0);
        local shield, scorch, fire = Dress(agent, color);
        tanks[agent:GetId()] = { tank = tank, agent = agent, shield = shield, scorch = scorch, fire = fire };
        grid:AddBody(agent, tank);
    end
    game:LookAround();
end

local function ShowTanks()
    for _, shown in pairs(tanks) do
        local tank = shown.tank;
        -- A label shows health from 0 to 100.
        shown.agent:SetHealth(math.max(1, 100 * tank.health / game.mostHealth));
        shown.agent:SetScore(tank.score);
        Core.SetVisible(shown.shield, tank.shields);
        Core.SetVisible(shown.scorch, tank.health <= game.mostHealth / 2);
        Core.SetVisible(shown.fire, tank.health <= game.mostHealth / 4);
    end
end

-- Missiles ------------------------------------------------------------------------------------------------------------

local function MissileNode(missile)
    local node = Core.CreateCapsule(grid.sandbox, 0.5, 0.12);
    Core.SetMaterial(node, "RedGlow");
    local isAcross = missile.direction == "east" or missile.direction == "west";
    Core.SetRotation(node, isAcross and Vector.new(0, 0, 90) or Vector.new(90, 0, 0));
    return node;
end

-- Removes missiles that no longer exist, lets new ones leave their tank, and moves the others.
local function AimMissiles()
    local isThere = {};
    for _, missile in ipairs(game.flying) do
        local shown = missiles[missile.number];
        local place = grid:PlaceOf(missile.x, missile.y, kMissileUp);
        if (not shown) then
            local step = GridBoard.Steps[missile.direction];
            shown = { node = MissileNode(missile), to = grid:PlaceOf(missile.x - step.x, missile.y - step.y, kMissileUp) };
            missiles[missile.number] = shown;
        end
        shown.from, shown.to = shown.to, place;
        isThere[missile.number] = true;
    end
    for number, shown in pairs(missiles) do
        if (not isThere[number]) then
            Core.Remove(shown.node);
            missiles[number] = nil;
        end
    end
end

local function FlyMissiles(share)
    for _, shown in pairs(missiles) do
        Core.SetPosition(shown.node, shown.from + (shown.to - shown.from) * share);
    end
end

-- What lasts for a tick -----------------------------------------------------------------------------------------------

local function DrawRadar()
    for _, shown in pairs(tanks) do
        for _, echo in ipairs(shown.tank.echoes or {}) do
            local isInside = echo.x >= 1 and echo.x <= game.width and echo.y >= 1 and echo.y <= game.height;
            if (isInside) then
                Core.DrawSquare(grid:PlaceOf(echo.x, echo.y, 0.12), GridGame.Cell * 0.86, kRadarColor, echo.kind ~= "obstacle");
            end
        end
    end
end

local function DrawBlasts(share)
    for _, place in ipairs(blasts) do
        local color = Vector.new(1, 0.75 - 0.5 * share, 0.1);
        if (share < 0.7) then
            Core.DrawSphere(grid:PlaceOf(place.x, place.y, 0.7), 0.6 * (1 - share), color, true);
        end
        Core.DrawCircle(grid:PlaceOf(place.x, place.y, 0.3), 0.3 + 0.6 * share, color);
        Core.DrawCircle(grid:PlaceOf(place.x, place.y, 0.3), 0.2 + 0.4 * share, color);
    end
end

-- Turns ---------------------------------------------------------------------------------------------------------------

local function ShowScores(sandbox)
    local lines = { string.format("turn %-5dpoints health energy missiles", game.turn) };
    for _, agent in ipairs(Sandbox.GetAgents(sandbox)) do
        local shown = tanks[agent:GetId()];
        if (shown) then
            local tank = shown.tank;
            lines[#lines + 1] = GridGame.NameRow(tank.color)
                .. string.format("%6d %6d %6d %8d", tank.score, tank.health, tank.energy, tank.missiles);
        end
    end
    grid:ShowTable(lines);
end

local function Play(sandbox)
    Begin(sandbox);
    if (game.isOver) then
        return;
    end
    game:Turn();
    blasts = game.explosions;
    ShowTanks();
    ShowPacks();
    AimMissiles();
    ShowScores(sandbox);
    if (game.isOver) then
        local winner;
        for _, tank in ipairs(game.tanks) do
            winner = (not winner or tank.score > winner.score) and tank or winner;
        end
        Sandbox.End(sandbox, winner.color .. " wins");
    end
end

function Sandbox_Initialize(sandbox)
    game = TankSoarRules.new(MapFile.Settings(sandbox, TankSoar.Settings, TankSoarMaps.file));
    grid = GridGame.new(sandbox, game.width, game.height);
    grid:BuildBoard("Soarbox/BoardLight", "Soarbox/BoardDark", "Soarbox/Stone");
    BuildCells();
    ShowPacks();
    grid:LookAtBoard();
end

function Sandbox_Sense(sandbox, agent)
    if (not grid) then -- The board is faulty; this was reported.
        return;
    end
    Begin(sandbox);
    local shown = tanks[agent:GetId()];
    local hasTurn = shown and grid:IsDecisionTick() and not game.isOver;
    return hasTurn and game:Percepts(shown.tank) or nil;
end

function Sandbox_Command(sandbox, agent, command, parameters)
    return game:Command(tanks[agent:GetId()].tank, command, parameters);
end

function Sandbox_Update(sandbox)
    if (not grid) then -- The board is faulty; this was reported.
        return;
    end
    local share = grid:Advance(function() Play(sandbox); end);
    FlyMissiles(share);
    DrawRadar();
    DrawBlasts(share);
end

function Sandbox_HandleEvent(sandbox, event)
    if (grid and event.source == "keyboard" and event.pressed and event.key == "f1_key") then
        grid:LookAtBoard();
    end
end
