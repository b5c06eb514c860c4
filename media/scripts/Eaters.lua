-- SPDX-License-Identifier: BSD-2-Clause
-- The visible world of Eaters: the board and the eaters of EatersRules.lua. A scenario uses this script, or its own
-- script, which sets Eaters.Settings first:
--     require "Eaters";
--     Eaters.Settings = { map = { "#.*#", "1..2" } };
require "EaterBody";
require "EatersMaps";
require "EatersRules";
require "GridGame";
require "MapFile";

Eaters = { Settings = {} };

local game, grid;
local food = {};      -- Node by place.
local lids = {};      -- Of the boxes that are closed: node by box.
local players = {};   -- By agent id.

local function PlaceName(x, y)
    return x .. "," .. y;
end

-- The board -----------------------------------------------------------------------------------------------------------

local function ShowCell(x, y)
    local content = game:ContentAt(x, y);
    if (content == "wall") then
        grid:PutBox(x, y, Vector.new(1.5, 1, 1.5), "Soarbox/Hedge");
    elseif (content == "normalfood") then
        food[PlaceName(x, y)] = grid:PutBall(x, y, 0.24, "BlueGlow", 0.45);
    elseif (content ~= "empty") then
        local node = grid:PutBox(x, y, Vector.new(0.46, 0.46, 0.46), "RedGlow", 0.25);
        food[PlaceName(x, y)] = node;
    end
end

-- A box without a lid is open. Treats are flat and stay.
local function ShowBoxes()
    for _, box in ipairs(game.boxes) do
        local material = GridGame.Materials[box.color] or "Soarbox/Ammunition";
        grid:PutBox(box.x, box.y, Vector.new(1.1, 0.5, 1.1), material);
        lids[box] = grid:PutBox(box.x, box.y, Vector.new(1.2, 0.14, 1.2), "Soarbox/Stone", 0.52);
    end
    for _, treat in ipairs(game.treats) do
        grid:PutBox(treat.x, treat.y, Vector.new(0.8, 0.12, 0.8), "Soarbox/Purple", 0.02);
    end
end

local function TakeLidsOff()
    for box, lid in pairs(lids) do
        if (box.isOpen) then
            Core.SetVisible(lid, false);
            lids[box] = nil;
        end
    end
end

local function HideEatenFood()
    for _, place in ipairs(game.cleared) do
        local name = PlaceName(place.x, place.y);
        if (food[name]) then
            Core.SetVisible(food[name], false);
            food[name] = nil;
        end
    end
end

-- Eaters --------------------------------------------------------------------------------------------------------------

-- The scenario's agents join in their order.
local function Begin(sandbox)
    if (next(players)) then
        return;
    end
    for i, agent in ipairs(Sandbox.GetAgents(sandbox)) do
        local color = GridGame.Colors[(i - 1) % #GridGame.Colors + 1];
        local eater = game:Join(color);
        players[agent:GetId()] = eater;
        agent:SetTeam(color);
        agent:SetScore(0);
        EaterBody_Dress(agent, GridGame.Materials[color]);
        grid:AddBody(agent, eater);
    end
    HideEatenFood();
end

-- Turns ---------------------------------------------------------------------------------------------------------------

local function ShowScores(sandbox)
    local lines = { string.format("turn %-4d food %d, worth %d", game.turn, game.foodLeft, game.pointsLeft) };
    for _, agent in ipairs(Sandbox.GetAgents(sandbox)) do
        local eater = players[agent:GetId()];
        if (eater) then
            agent:SetScore(eater.score);
            lines[#lines + 1] = GridGame.NameRow(eater.color) .. string.format("%6d", eater.score);
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
    HideEatenFood();
    TakeLidsOff();
    ShowScores(sandbox);
    if (game.isOver) then
        Sandbox.End(sandbox, #game.boxes > 0 and "all boxes are open" or "all is eaten");
    end
end

function Sandbox_Initialize(sandbox)
    game = EatersRules.new(MapFile.Settings(sandbox, Eaters.Settings, EatersMaps));
    grid = GridGame.new(sandbox, game.width, game.height);
    grid:BuildBoard("Soarbox/BoardLight", "Soarbox/BoardDark", "Soarbox/Stone");
    for y = 1, game.height do
        for x = 1, game.width do
            ShowCell(x, y);
        end
    end
    ShowBoxes();
    grid:LookAtBoard();
end

function Sandbox_Sense(sandbox, agent)
    if (not grid) then -- The board is faulty; this was reported.
        return;
    end
    Begin(sandbox);
    local eater = players[agent:GetId()];
    local hasTurn = eater and grid:IsDecisionTick() and not game.isOver;
    return hasTurn and game:Percepts(eater) or nil;
end

function Sandbox_Command(sandbox, agent, command, parameters)
    return game:Command(players[agent:GetId()], command, parameters);
end

function Sandbox_Update(sandbox)
    if (not grid) then -- The board is faulty; this was reported.
        return;
    end
    grid:Advance(function() Play(sandbox); end);
    for _, place in ipairs(game.collisions) do
        Core.DrawCircle(grid:PlaceOf(place.x, place.y, 0.3), 1.1, Vector.new(1, 0.7, 0.1));
    end
end

function Sandbox_HandleEvent(sandbox, event)
    if (grid and event.source == "keyboard" and event.pressed and event.key == "f1_key") then
        grid:LookAtBoard();
    end
end
