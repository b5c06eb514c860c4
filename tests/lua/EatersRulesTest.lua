-- SPDX-License-Identifier: BSD-2-Clause
-- The rules of Eaters, one test for each.
require "Check";
require "EatersRules";

local tests = {};

-- A game on this map. Eaters, named by their colours, begin at the digits 1, 2 ...
local function Game(map, settings)
    local colors = { "red", "blue", "yellow" };
    settings = settings or {};
    settings.map = map;
    settings.random = settings.random or function() return 1; end;
    local game = EatersRules.new(settings);
    local eaters = {};
    for number in ipairs(game.starts) do
        eaters[number] = game:Join(colors[number]);
    end
    return game, eaters[1], eaters[2], eaters[3];
end

local function Play(game, eater, command, direction)
    local reason = game:Command(eater, command, { direction = direction });
    game:Turn();
    return reason;
end

local function CheckPlace(eater, x, y)
    CheckEqual(x, eater.x);
    CheckEqual(y, eater.y);
end

function tests.AMoveGoesOneCellAndEatsWhatLiesThere()
    local game, red = Game({ "1.*" });
    CheckEqual(nil, Play(game, red, "move", "east"));
    CheckPlace(red, 2, 1);
    CheckEqual(5, red.score);
    Play(game, red, "move", "east");
    CheckEqual(15, red.score);
    CheckEqual("empty", game:ContentAt(3, 1));
end

function tests.AMoveIntoAWallOrOffTheBoardCostsFivePoints()
    local game, red = Game({ "1#." });
    Play(game, red, "move", "east");
    CheckPlace(red, 1, 1);
    CheckEqual(-5, red.score);
    Play(game, red, "move", "north");
    CheckEqual(-10, red.score);
end

function tests.AJumpGoesTwoCellsOverAnythingForFivePoints()
    local game, red = Game({ "1#*.." });
    Play(game, red, "jump", "east");
    CheckPlace(red, 3, 1);
    CheckEqual(5, red.score);
    Play(game, red, "jump", "east");
    CheckPlace(red, 5, 1);
    CheckEqual("normalfood", game:ContentAt(4, 1));
    CheckEqual(5, red.score);
end

function tests.AJumpIntoAWallCostsWhatAMoveIntoOneCosts()
    local game, red = Game({ "1.#" });
    Play(game, red, "jump", "east");
    CheckPlace(red, 1, 1);
    CheckEqual(-5, red.score);
end

function tests.WhoDoesNothingStaysWhereItIs()
    local game, red = Game({ "1." });
    game:Turn();
    CheckPlace(red, 1, 1);
    CheckEqual(nil, Play(game, red, "move", "none"));
    CheckPlace(red, 1, 1);
    CheckEqual(0, red.score);
end

function tests.AnEaterThatFastsLeavesTheFoodAndMayEatItLater()
    local game, red = Game({ "1*" });
    CheckEqual(nil, game:Command(red, "dont-eat", {}));
    Play(game, red, "move", "east");
    CheckEqual(0, red.score);
    CheckEqual("bonusfood", game:ContentAt(2, 1));
    local content = game:Percepts(red)["my-location"].content;
    CheckEqual("eater", content[1]);
    CheckEqual("bonusfood", content[2]);
    game:Turn();
    CheckEqual(10, red.score);
end

function tests.CommandsThatAreNoneSayWhy()
    local game, red = Game({ "1." });
    CheckEqual("unknown-command", game:Command(red, "fly", {}));
    CheckEqual("no-such-direction", game:Command(red, "move", { direction = "up" }));
    CheckEqual("no-such-direction", game:Command(red, "jump", {}));
    CheckEqual(nil, game:Command(red, "move", { direction = "east" }));
    CheckEqual("one-move-a-turn", game:Command(red, "move", { direction = "west" }));
    game:Turn();
    CheckPlace(red, 2, 1);
    CheckEqual(nil, game:Command(red, "move", { direction = "west" }));
end

function tests.ARefusalSaysWhatIsWrongAndWhatThereIs()
    local game, red = Game({ "1." });
    local _, details = game:Command(red, "mvoe", { direction = "east" });
    CheckEqual("there is no command ^mvoe", details.text);
    CheckEqual("mvoe", details.given);
    CheckEqual("dont-eat jump move open", table.concat(details.known, " "));
    _, details = game:Command(red, "move", { direction = "nroth" });
    CheckEqual("^direction of ^move is nroth", details.text);
    CheckEqual("north east south west none", table.concat(details.known, " "));
    _, details = game:Command(red, "jump", { dirction = "north", status = "complete" });
    CheckEqual("^jump requires ^direction (north, east, south, west), and has ^dirction", details.text);
    _, details = game:Command(red, "move", { direction = {} });
    CheckEqual("^direction of ^move is an identifier", details.text);
    CheckEqual(nil, game:Command(red, "move", { direction = "east", speed = "fast" }));
end

function tests.OldAgentsMayWriteCapitals()
    local game, red = Game({ "1." });
    CheckEqual(nil, Play(game, red, "Move", "EAST"));
    CheckPlace(red, 2, 1);
end

function tests.AnEaterBeginsWhereItCanJump()
    -- The random place would be in the north-west, from which no jump is possible.
    local game = EatersRules.new({ map = { ".##..", "##...", "##..." }, random = function() return 1; end });
    CheckPlace(game:Join("red"), 4, 1);
    -- If there is no place with a possible jump, any place is used.
    CheckPlace(EatersRules.new({ map = { ".." }, random = function() return 2; end }):Join("red"), 2, 1);
end

-- Boxes, treats and food that decays ----------------------------------------------------------------------------------

function tests.FoodThatDecaysLosesItsWorthTurnByTurnUntilItIsGone()
    local foods = { { name = "dn", content = "normalfood", sign = ".", points = 3, decay = 1 } };
    local game, red = Game({ "1..." }, { foods = foods });
    CheckEqual("normalfood", game:ContentAt(3, 1));
    Play(game, red, "move", "east");
    CheckEqual(3, red.score);
    Play(game, red, "move", "east");
    CheckEqual(5, red.score);
    game:Turn();
    CheckEqual("empty", game:ContentAt(4, 1));
    CheckEqual(true, game.isOver);
end

function tests.FoodMayTakePoints()
    local foods = { { name = "nn", content = "normalfood", sign = ".", points = -1 } };
    local game, red = Game({ "1." }, { foods = foods });
    Play(game, red, "move", "east");
    CheckEqual(-1, red.score);
end

function tests.ABoxBringsItsPointsOnceAndTheGameGoesOnUntilAllAreOpen()
    local boxes = { { x = 2, y = 1, id = "box", color = "green", shape = "square", points = 20 } };
    local game, red = Game({ "1 " }, { boxes = boxes });
    local east = game:Percepts(red)["my-location"].east;
    CheckEqual(nil, east.content);
    CheckEqual("green", east.box.color);
    CheckEqual(nil, east.box.status);
    CheckEqual(nil, game:Command(red, "open", {}));
    game:Turn();
    CheckEqual(0, red.score);
    CheckEqual(false, game.isOver);
    game:Command(red, "open", {});
    Play(game, red, "move", "east");
    CheckEqual(20, red.score);
    CheckEqual(true, game.isOver);
    local here = game:Percepts(red)["my-location"];
    CheckEqual("open", here.box.status);
    CheckEqual("eater", here.content);
    game:Command(red, "open", {});
    game:Turn();
    CheckEqual(20, red.score);
end

function tests.TheInfoBoxSaysWhichRewardBoxIsTheRightOne()
    local boxes = {
        { x = 1, y = 1, id = "box", reward = 10 }, { x = 3, y = 1, id = "box", reward = 10 },
        { x = 2, y = 1, id = "info-box", isInfo = true, needsCode = true }
    };
    local game, red = Game({ " 1 " }, { boxes = boxes, random = function(most) return most and 2 or 0; end });
    game:Command(red, "open", {});
    game:Turn();
    local info = game:Percepts(red)["my-location"]["info-box"];
    CheckEqual(2, info["positive-box-id"]);
    CheckEqual(2, info["open-code"]);
    game:Command(red, "open", { code = "2" });
    Play(game, red, "move", "west");
    CheckEqual(-1, red.score);
    CheckEqual(false, game.isOver);
    game:Command(red, "open", { code = "2" });
    Play(game, red, "jump", "east");
    CheckEqual(-1 - 5 + 10, red.score);
    CheckEqual(true, game.isOver);
end

function tests.TheRightBoxBringsOnePointWithTheWrongCode()
    local boxes = { { x = 2, y = 1, reward = 10 }, { x = 1, y = 1, id = "info-box", isInfo = true, needsCode = true } };
    local game, red = Game({ "1 " }, { boxes = boxes });
    game:Command(red, "open", { code = "7" });
    Play(game, red, "move", "east");
    CheckEqual(1, red.score);
end

function tests.ATreatBringsPointsToEachWhoComes()
    local game, red = Game({ "1 ." }, { treats = { { x = 2, y = 1, points = 1 } } });
    Play(game, red, "move", "east");
    Play(game, red, "move", "west");
    game:Turn();
    Play(game, red, "move", "east");
    CheckEqual(2, red.score);
end

function tests.TwoInOneCellShareTheirPointsAndAreThrownElsewhere()
    local game, red, blue = Game({ "1.2", "   " });
    red.score, blue.score = 10, 3;
    game:Command(red, "move", { direction = "east" });
    game:Command(blue, "move", { direction = "west" });
    game:Turn();
    -- The first of them eats the food in the cell: (10 + 5 + 3) / 2.
    CheckEqual(9, red.score);
    CheckEqual(9, blue.score);
    CheckPlace(red, 1, 1);
    Check(red.x ~= blue.x or red.y ~= blue.y);
    CheckEqual(1, #game.collisions);
    CheckEqual(2, game.collisions[1].x);
    Check(red.wasThrown and blue.hasMoved);
end

function tests.WhatIsLeftOverIsLostAndADebtIsNotShared()
    local game, red, blue = Game({ "1 2", "   " });
    red.score, blue.score = 10, 3;
    game:Command(red, "move", { direction = "east" });
    Play(game, blue, "move", "west");
    CheckEqual(6, red.score);
    CheckEqual(6, blue.score);
    local other, one, two = Game({ "1 2", "   " });
    one.score, two.score = -10, 5;
    other:Command(one, "move", { direction = "east" });
    Play(other, two, "move", "west");
    CheckEqual(-10, one.score);
    CheckEqual(5, two.score);
end

function tests.WhoIsThrownEatsWhereItLands()
    local game, red, blue = Game({ "1 2", ".  " }, { random = function(most) return most and 3 or 0; end });
    game:Command(red, "move", { direction = "east" });
    Play(game, blue, "move", "west");
    -- The free cells are 1,1 and 3,1 and 1,2, in this order. The first eater gets the third one.
    CheckPlace(red, 1, 2);
    CheckEqual(5, red.score);
end

function tests.ThoseWhoChangePlacesDoNotCollide()
    local game, red, blue = Game({ "12" });
    game:Command(red, "move", { direction = "east" });
    Play(game, blue, "move", "west");
    CheckPlace(red, 2, 1);
    CheckPlace(blue, 1, 1);
    CheckEqual(0, #game.collisions);
end

function tests.ThreeInOneCellAreOneCollision()
    local game, red, blue, yellow = Game({ "1 2", " 3 ", "   " });
    game:Command(red, "move", { direction = "east" });
    game:Command(blue, "move", { direction = "west" });
    Play(game, yellow, "move", "north");
    CheckEqual(1, #game.collisions);
end

function tests.TheGameIsOverWhenNothingIsLeftToEat()
    local game, red = Game({ "1.." });
    Play(game, red, "move", "east");
    CheckEqual(false, game.isOver);
    local count, points = game:FoodLeft();
    CheckEqual(1, count);
    CheckEqual(5, points);
    Play(game, red, "move", "east");
    CheckEqual(true, game.isOver);
end

function tests.WhereAnEaterBeginsThereIsNoFood()
    local game = EatersRules.new({ map = { ".." }, random = function() return 2; end });
    local eater = game:Join("red");
    CheckPlace(eater, 2, 1);
    CheckEqual("empty", game:ContentAt(2, 1));
    CheckEqual(0, eater.score);
end

function tests.AnEaterPerceivesTheCellsAroundItThroughTheirDirections()
    local game, red = Game({ "...", ".1*", "..." });
    local here = game:Percepts(red)["my-location"];
    CheckEqual("eater", here.content);
    CheckEqual("bonusfood", here.east.content);
    CheckEqual("wall", here.east.east.content);
    CheckEqual(nil, here.east.east.east);
    -- All paths to a cell lead to the same object.
    Check(rawequal(here.north.east, here.east.north));
    Check(rawequal(here.north.south, here));
end

function tests.AnEaterPerceivesItselfAndOthers()
    local game, red, blue = Game({ "1.2" });
    blue.score = 30;
    Play(game, red, "jump", "west");
    local percepts = game:Percepts(red);
    CheckEqual("red", percepts.eater.name);
    CheckEqual(-5, percepts.eater.score);
    CheckEqual(1, percepts.eater.x);
    CheckEqual(1, percepts.eater.y);
    CheckEqual("west", percepts.eater.direction);
    local other = percepts["my-location"].east.east;
    CheckEqual("eater", other.content);
    CheckEqual("blue", other["eater-color"]);
    CheckEqual(30, other["eater-score"]);
end

function tests.ContentsAreNewOnceAnEaterHasMoved()
    local game, red = Game({ "1.#" });
    CheckEqual(true, game:Percepts(red)["my-location"].east._new);
    game:Turn();
    CheckEqual(false, game:Percepts(red)["my-location"].east._new);
    Play(game, red, "move", "east");
    CheckEqual(true, game:Percepts(red)["my-location"]._new);
    Play(game, red, "move", "east");
    CheckEqual(false, game:Percepts(red)["my-location"]._new);
end

function tests.RandomWallsTouchNeitherTheEdgeNorEachOthersCorners()
    for _ = 1, 20 do
        local game = EatersRules.new({});
        for y = 1, game.height do
            for x = 1, game.width do
                if (game:ContentAt(x, y) == "wall") then
                    Check(x > 1 and x < game.width and y > 1 and y < game.height, "a wall at the edge");
                    for _, corner in ipairs({ { -1, -1 }, { 1, -1 }, { -1, 1 }, { 1, 1 } }) do
                        Check(game:ContentAt(x + corner[1], y + corner[2]) ~= "wall", "walls meet at a corner");
                    end
                else
                    Check(game:WorthAt(x, y), "a cell without food");
                end
            end
        end
    end
end

function tests.AFaultyMapSaysWhere()
    local _, message = pcall(EatersRules.new, { map = { "..", "." } });
    Check(message:find("line 2 of the map has 1 cells, and the first has 2", 1, true), message);
    _, message = pcall(EatersRules.new, { map = { "..", ".?" } });
    Check(message:find("line 2 of the map has '?'", 1, true), message);
end

RunTests(tests);
