-- SPDX-License-Identifier: BSD-2-Clause
-- The visible world of Simple Eaters: the board and the eater of SimpleEatersRules.lua. A scenario uses this script, or
-- its own script, which sets SimpleEaters.Settings first, as with Eaters.lua.
require "EaterBody";
require "GridGame";
require "SimpleEatersRules";

SimpleEaters = { Settings = {} };

local kFoods = { red = "RedGlow", purple = "Soarbox/Purple", green = "GreenGlow", blue = "BlueGlow" };
local game, grid;
local food = {};   -- Node by place.
local seat;        -- { agent, player }: the first agent plays.

-- The board counts rows from the north, the game from the south.
local function Row(y)
    return game.height - y;
end

local function BuildCells()
    for y = 0, game.height - 1 do
        for x = 0, game.width - 1 do
            local content = game:ContentAt(x, y);
            if (content == "wall") then
                grid:PutBox(x + 1, Row(y), Vector.new(1.5, 1, 1.5), "Soarbox/Hedge");
            elseif (kFoods[content]) then
                food[x .. "," .. y] = grid:PutBall(x + 1, Row(y), 0.3, kFoods[content], 0.5);
            end
        end
    end
end

local function Begin(sandbox)
    local agent = Sandbox.GetAgents(sandbox)[1];
    if (seat or not agent) then
        return;
    end
    seat = { agent = agent, player = { x = game.x + 1, y = Row(game.y), direction = game.orientation } };
    agent:SetScore(0);
    EaterBody_Dress(agent, "Soarbox/Yellow");
    grid:AddBody(agent, seat.player);
end

local function Play(sandbox)
    Begin(sandbox);
    if (game.isOver or not seat) then
        return;
    end
    local isIdle = not game.wish;
    game:Turn();
    seat.player.x, seat.player.y, seat.player.direction = game.x + 1, Row(game.y), game.orientation;
    seat.agent:SetScore(game.score);
    local name = game.x .. "," .. game.y;
    if (food[name]) then
        Core.SetVisible(food[name], false);
        food[name] = nil;
    end
    grid:ShowTable({ string.format("turn %d   food left: %d", game.turn, game:FoodLeft()),
                     string.format("score %d", game.score) });
    if (game.isOver) then
        Sandbox.End(sandbox, "task complete");
    elseif (isIdle and game:FoodLeft() == 0) then
        Sandbox.End(sandbox, "all is eaten");  -- Minds of the tutorial halt then, in any cell.
    end
end

function Sandbox_Initialize(sandbox)
    game = SimpleEatersRules.new(SimpleEaters.Settings);
    grid = GridGame.new(sandbox, game.width, game.height);
    grid:BuildBoard("Soarbox/BoardLight", "Soarbox/BoardDark", "Soarbox/Stone");
    BuildCells();
    grid:LookAtBoard();
end

-- The mind perceives only after the last turn that the task is complete.
local told = false;
function Sandbox_Sense(sandbox, agent)
    if (not grid) then -- The board is faulty; this was reported.
        return;
    end
    Begin(sandbox);
    if (agent ~= seat.agent or not grid:IsDecisionTick() or told) then
        return nil;
    end
    told = game.isOver;
    return game:Percepts();
end

function Sandbox_Command(_, _, command, parameters)
    return game:Command(command, parameters);
end

function Sandbox_Update(sandbox)
    if (not grid) then -- The board is faulty; this was reported.
        return;
    end
    grid:Advance(function() Play(sandbox); end);
    if (game.hitWall) then
        Core.DrawCircle(grid:PlaceOf(game.x + 1, Row(game.y), 0.3), 0.8, Vector.new(1, 0.2, 0.1));
    end
end

function Sandbox_HandleEvent(sandbox, event)
    if (grid and event.source == "keyboard" and event.pressed and event.key == "f1_key") then
        grid:LookAtBoard();
    end
end
