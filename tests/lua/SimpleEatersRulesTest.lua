-- SPDX-License-Identifier: BSD-2-Clause
-- The rules of Simple Eaters, one test for each.
require "Check";
require "SimpleEatersRules";

local tests = {};

local function Play(game, command)
    local reason = game:Command(command);
    game:Turn();
    return reason;
end

function tests.TheBoardIsThatOfTheTutorial()
    local game = SimpleEatersRules.new();
    local percepts = game:Percepts();
    CheckEqual(1, percepts.x);
    CheckEqual(2, percepts.y);
    CheckEqual("east", percepts.orientation);
    CheckEqual("red", percepts.east);
    CheckEqual("wall", percepts.north);
    CheckEqual("purple", percepts.west);
    CheckEqual("red", percepts.south);
    CheckEqual(9, percepts["food-remaining"]);
    CheckEqual(1, percepts.time);
    CheckEqual("nil", percepts["score-diff"]);
    CheckEqual("here", percepts.finish);
end

function tests.ForwardGoesOneCellAndEats()
    local game = SimpleEatersRules.new();
    CheckEqual(nil, Play(game, "forward"));
    local percepts = game:Percepts();
    CheckEqual(2, percepts.x);
    CheckEqual(5 - 1, percepts.score);
    CheckEqual(4, percepts["score-diff"]);
    CheckEqual("green", percepts.front);
    CheckEqual("empty", percepts.back);
    CheckEqual(8, percepts["food-remaining"]);
    CheckEqual(nil, percepts.finish);
    Play(game, "forward");
    CheckEqual(4 + 15 - 1, game.score);
end

function tests.EachFoodHasItsPoints()
    for sign, points in pairs({ r = 5, p = 10, g = 15, b = 20 }) do
        local game = SimpleEatersRules.new({ map = { "1" .. sign }, timePenalty = 0 });
        Play(game, "forward");
        CheckEqual(points, game.score);
    end
end

function tests.RotateTurnsAQuarterToTheRight()
    local game = SimpleEatersRules.new();
    for _, orientation in ipairs({ "south", "west", "north", "east" }) do
        Play(game, "rotate");
        CheckEqual(orientation, game:Percepts().orientation);
    end
    CheckEqual(-4, game.score);
end

function tests.AWallStopsAndCosts()
    local game = SimpleEatersRules.new({ orientation = "north" });
    Play(game, "forward");
    CheckEqual(1, game.x);
    CheckEqual(2, game.y);
    CheckEqual(-11, game.score);
    Check(game.hitWall);
end

function tests.WhoDoesNothingPaysNothing()
    local game = SimpleEatersRules.new();
    game:Turn();
    CheckEqual(0, game.score);
    CheckEqual(2, game:Percepts().time);
    CheckEqual(0, game:Percepts()["score-diff"]);
end

function tests.TheFirstCommandOfATurnCounts()
    local game = SimpleEatersRules.new();
    CheckEqual(nil, game:Command("rotate"));
    CheckEqual("one-command-a-turn", game:Command("forward"));
    game:Turn();
    CheckEqual("south", game.orientation);
    CheckEqual(1, game.x);
    CheckEqual("unknown-command", game:Command("jump"));
end

function tests.TheTaskIsCompleteBackAtTheBeginning()
    local game = SimpleEatersRules.new({ map = { "1r" } });
    Play(game, "forward");
    CheckEqual(false, game.isOver);
    CheckEqual(nil, game:Percepts().task);
    Play(game, "rotate");
    Play(game, "rotate");
    Play(game, "forward");
    CheckEqual(true, game.isOver);
    CheckEqual("complete", game:Percepts().task);
    CheckEqual("here", game:Percepts().finish);
end

function tests.WhatLiesAroundIsNewOnlyAfterAForward()
    local game = SimpleEatersRules.new();
    local function IsNew(name)
        for _, other in ipairs(game:Percepts()._new) do
            if (other == name) then
                return true;
            end
        end
        return false;
    end
    Check(IsNew("east") and IsNew("front"));
    Play(game, "rotate");
    Check(not IsNew("east") and not IsNew("x") and IsNew("front") and IsNew("time"));
    Play(game, "forward");
    Check(IsNew("east") and IsNew("x"));
end

function tests.AFaultyMapSaysWhere()
    local _, message = pcall(SimpleEatersRules.new, { map = { "1r", "r" } });
    Check(message:find("line 2 of the map has 1 cells", 1, true), message);
    _, message = pcall(SimpleEatersRules.new, { map = { "1y" } });
    Check(message:find("line 1 of the map has 'y'", 1, true), message);
    _, message = pcall(SimpleEatersRules.new, { map = { "rr" } });
    Check(message:find("the map has no 1", 1, true), message);
end

RunTests(tests);
