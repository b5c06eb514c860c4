-- SPDX-License-Identifier: BSD-2-Clause
-- The rules of TankSoar, one test for each.
require "Check";
require "TankSoarRules";

local tests = {};

local function Always(number)
    return function(most) return most and math.min(number, most) or 0.5; end;
end

-- A game on this map. Tanks begin at the digits 1, 2 ... and face north. No packs appear.
local function Game(map, settings)
    local colors = { "red", "blue", "yellow" };
    settings = settings or {};
    settings.map, settings.random = map, settings.random or Always(1);
    settings.mostPacks = settings.mostPacks or 0;
    local game = TankSoarRules.new(settings);
    local tanks = {};
    for number in ipairs(game.starts) do
        tanks[number] = game:Join(colors[number]);
    end
    return game, tanks[1], tanks[2], tanks[3];
end

local function Wide(line)
    return { "H            E", "              ", line };
end

local function Do(game, tank, command, parameters)
    return game:Command(tank, command, parameters or {});
end

local function CheckPlace(tank, x, y)
    CheckEqual(x, tank.x);
    CheckEqual(y, tank.y);
end

-- Moving --------------------------------------------------------------------------------------------------------------

function tests.AMoveGoesOneCellRelativeToWhereTheTankFaces()
    local game, red = Game(Wide("  1           "));
    CheckEqual("north", red.direction);
    Do(game, red, "move", { direction = "right" });
    game:Turn();
    CheckPlace(red, 4, 3);
    Do(game, red, "rotate", { direction = "left" });
    game:Turn();
    CheckEqual("west", red.direction);
    Do(game, red, "move", { direction = "forward" });
    game:Turn();
    CheckPlace(red, 3, 3);
    Do(game, red, "move", { direction = "backward" });
    game:Turn();
    CheckPlace(red, 4, 3);
    Do(game, red, "move", { direction = "none" });
    game:Turn();
    CheckPlace(red, 4, 3);
end

function tests.WhoRotatesDoesNotMove()
    local game, red = Game(Wide("  1           "));
    Do(game, red, "move", { direction = "right" });
    Do(game, red, "rotate", { direction = "right" });
    game:Turn();
    CheckPlace(red, 3, 3);
    CheckEqual("east", red.direction);
    Do(game, red, "rotate", { direction = "right" });
    CheckEqual("move-or-rotate", Do(game, red, "move", { direction = "right" }));
end

function tests.AnObstacleStopsATankAndCostsHealth()
    local game, red = Game(Wide(" #1           "));
    Do(game, red, "move", { direction = "left" });
    game:Turn();
    CheckPlace(red, 3, 3);
    CheckEqual(900, red.health);
    CheckEqual(0, red.score);
end

function tests.TwoThatWantOneCellStayAndBothLoseHealth()
    local game, red, blue = Game(Wide("  1 2         "));
    Do(game, red, "move", { direction = "right" });
    Do(game, blue, "move", { direction = "left" });
    game:Turn();
    CheckPlace(red, 3, 3);
    CheckPlace(blue, 5, 3);
    CheckEqual(900, red.health);
    CheckEqual(900, blue.health);
end

function tests.TwoThatDriveAtEachOtherStay()
    local game, red, blue = Game(Wide("  12          "));
    Do(game, red, "move", { direction = "right" });
    Do(game, blue, "move", { direction = "left" });
    game:Turn();
    CheckPlace(red, 3, 3);
    CheckPlace(blue, 4, 3);
    CheckEqual(900, red.health);
    CheckEqual(900, blue.health);
end

function tests.ATankThatStandsIsRammed()
    local game, red, blue = Game(Wide("  12          "));
    Do(game, red, "move", { direction = "right" });
    game:Turn();
    CheckPlace(red, 3, 3);
    CheckEqual(900, red.health);
    CheckEqual(900, blue.health);
end

function tests.TanksMayFollowEachOther()
    local game, red, blue = Game(Wide("  12          "));
    Do(game, red, "move", { direction = "right" });
    Do(game, blue, "move", { direction = "right" });
    game:Turn();
    CheckPlace(red, 4, 3);
    CheckPlace(blue, 5, 3);
    CheckEqual(1000, red.health);
end

function tests.WhoIsSentBackIsInTheWayOfThoseBehind()
    local game, red, blue, yellow = Game(Wide(" 12 3         "));
    for _, tank in ipairs({ red, blue }) do
        Do(game, tank, "move", { direction = "right" });
    end
    Do(game, yellow, "move", { direction = "left" });
    game:Turn();
    CheckPlace(red, 2, 3);
    CheckPlace(blue, 3, 3);
    CheckPlace(yellow, 5, 3);
    CheckEqual(900, red.health);
    -- Both other tanks were in the way of the middle one.
    CheckEqual(800, blue.health);
    CheckEqual(900, yellow.health);
end

-- Missiles ------------------------------------------------------------------------------------------------------------

function tests.AMissileFliesFourCellsInThreeTurns()
    local game, red = Game({ "H #          E", "              ", "              ", "              ", "              ",
                             "              ", "              ", "              ", "  1           " });
    Do(game, red, "fire", { weapon = "missile" });
    game:Turn();
    CheckEqual(14, red.missiles);
    local places = { 8 };
    CheckEqual(8, game.flying[1].y);
    for _ = 1, 4 do
        game:Turn();
        places[#places + 1] = game.flying[1].y;
    end
    CheckEqual("8 7 5 4 3", table.concat(places, " "));
    game:Turn();
    CheckEqual(0, #game.flying);
    CheckEqual(1, game.explosions[1].y);
end

function tests.AHitCostsHealthOrWithShieldsEnergy()
    local game, red, blue = Game({ "H            E", "  2           ", "  1           " });
    Do(game, red, "fire");
    game:Turn();
    CheckEqual(600, blue.health);
    CheckEqual(2, red.score);
    CheckEqual(-1, blue.score);
    Do(game, blue, "shields", { switch = "on" });
    Do(game, red, "fire");
    game:Turn();
    CheckEqual(600, blue.health);
    CheckEqual(1000 - 20 - 250, blue.energy);
    CheckEqual(4, red.score);
end

function tests.RotatingComesBeforeFiring()
    local game, red, blue = Game(Wide("  12          "));
    Do(game, red, "rotate", { direction = "right" });
    Do(game, red, "fire");
    game:Turn();
    CheckEqual(600, blue.health);
end

function tests.WithoutMissilesNothingIsFired()
    local game, red = Game(Wide("  1           "), { missiles = 0 });
    Do(game, red, "fire");
    game:Turn();
    CheckEqual(0, #game.flying);
    CheckEqual(0, red.missiles);
end

function tests.WhoDrivesIntoAMissileIsHit()
    local game, red, blue = Game({ "H            E", "  2           ", "              ", "              ", "  1           " });
    Do(game, red, "fire");
    game:Turn();
    CheckEqual(4, game.flying[1].y);
    Do(game, blue, "move", { direction = "backward" });
    game:Turn();
    -- The tank has moved to row 3, and the missile has flown there.
    CheckEqual(600, blue.health);
    CheckEqual(0, #game.flying);
end

function tests.OnAChargerEachHitDestroys()
    local game, red, blue = Game({ "#            E", "#             ", "  1           " }, { random = Always(1) });
    blue = game:Join("blue");
    blue.x, blue.y = 3, 2;
    game.cells[2][3] = "health";
    Do(game, blue, "shields", { switch = "on" });
    Do(game, red, "fire");
    game:Turn();
    CheckEqual(2 + 3, red.score);
    CheckEqual(-1 - 2, blue.score);
    Check(blue.x ~= 3 or blue.y ~= 2);
    CheckEqual(1000, blue.health);
end

function tests.ADestroyedTankComesBackElsewhereAsNew()
    local game, red, blue = Game({ "H            E", "  2           ", "  1           " });
    blue.health, blue.energy, blue.missiles = 300, 10, 2;
    Do(game, blue, "radar", { switch = "on" });
    Do(game, red, "fire");
    game:Turn();
    CheckPlace(blue, 2, 1);
    CheckEqual(1000, blue.health);
    CheckEqual(1000, blue.energy);
    CheckEqual(15, blue.missiles);
    CheckEqual("yes", game:Percepts(blue).resurrect);
    CheckEqual("on", game:Percepts(blue)["radar-status"]);
    CheckEqual(5, red.score);
    CheckEqual(-3, blue.score);
    game:Turn();
    CheckEqual("no", game:Percepts(blue).resurrect);
end

function tests.RammingToDestructionIsRewardedAndAnObstacleIsNot()
    local game, red, blue = Game(Wide("  12          "));
    blue.health = 100;
    Do(game, red, "move", { direction = "right" });
    game:Turn();
    CheckEqual(3, red.score);
    CheckEqual(-2, blue.score);
    red.health = 50;
    red.x, red.y, red.direction = 1, 3, "west";
    Do(game, red, "move", { direction = "forward" });
    game:Turn();
    CheckEqual(1, red.score);
end

-- Energy and supplies -------------------------------------------------------------------------------------------------

function tests.ShieldsCostEnergyAndFallWithoutAny()
    local game, red = Game(Wide("  1           "));
    Do(game, red, "shields", { switch = "on" });
    game:Turn();
    CheckEqual(980, red.energy);
    red.energy = 10;
    game:Turn();
    CheckEqual(0, red.energy);
    CheckEqual(true, red.shields);
    game:Turn();
    CheckEqual("off", game:Percepts(red)["shield-status"]);
end

function tests.RadarCostsItsPowerAndSinksToWhatIsLeft()
    local game, red = Game(Wide("  1           "));
    Do(game, red, "radar", { switch = "on" });
    Do(game, red, "radar-power", { setting = 9 });
    game:Turn();
    CheckEqual(991, red.energy);
    red.energy = 4;
    game:Turn();
    CheckEqual(0, red.energy);
    CheckEqual(4, game:Percepts(red)["radar-setting"]);
    game:Turn();
    CheckEqual("off", game:Percepts(red)["radar-status"]);
    CheckEqual(0, game:Percepts(red)["radar-distance"]);
end

function tests.TheRadarsPowerHasBounds()
    local game, red = Game(Wide("  1           "));
    Do(game, red, "radar-power", { setting = 99 });
    game:Turn();
    CheckEqual(14, red.radarPower);
    Do(game, red, "radar-power", { setting = -3 });
    game:Turn();
    CheckEqual(0, red.radarPower);
    CheckEqual("no-such-setting", Do(game, red, "radar-power", { setting = "much" }));
    CheckEqual("no-such-setting", Do(game, red, "radar-power", {}));
end

function tests.ChargersFillUpWhoIsOnThem()
    local game, red = Game({ "H1           E", "              ", "              " });
    red.health = 500;
    Do(game, red, "move", { direction = "left" });
    game:Turn();
    CheckEqual(650, red.health);
    CheckEqual("yes", game:Percepts(red).healthrecharger);
    CheckEqual("no", game:Percepts(red).energyrecharger);
    red.health = 950;
    game:Turn();
    CheckEqual(1000, red.health);
    red.x, red.energy = 14, 100;
    game:Turn();
    CheckEqual(350, red.energy);
    CheckEqual("yes", game:Percepts(red).energyrecharger);
end

function tests.APackOfMissilesIsTakenByWhoDrivesThere()
    local game, red = Game(Wide("  1M          "));
    Do(game, red, "move", { direction = "right" });
    game:Turn();
    CheckEqual(22, red.missiles);
    CheckEqual("open", game:ContentAt(4, 3));
end

function tests.PacksAppearNowAndThen()
    local game = Game(Wide("  1           "), { mostPacks = 3, random = Always(1) });
    local count = 0;
    for x = 1, 14 do
        for y = 1, 3 do
            count = count + (game:ContentAt(x, y) == "missiles" and 1 or 0);
            game.cells[y][x] = game:ContentAt(x, y) == "missiles" and "open" or game.cells[y][x];
        end
    end
    CheckEqual(3, count);
    game:Turn();
    CheckEqual("missiles", game:ContentAt(2, 1));
end

function tests.AMapWithoutChargersGetsThem()
    local game = TankSoarRules.new({ map = { "    ", "    " }, mostPacks = 0, random = Always(1) });
    CheckEqual("energy", game:ContentAt(1, 1));
    CheckEqual("health", game:ContentAt(2, 1));
end

-- Senses --------------------------------------------------------------------------------------------------------------

function tests.BlockedTellsOfObstaclesAndTanks()
    local game, red = Game(Wide(" #12          "));
    local blocked = game:Percepts(red).blocked;
    CheckEqual("yes", blocked.left);
    CheckEqual("yes", blocked.right);
    CheckEqual("no", blocked.forward);
    CheckEqual("yes", blocked.backward);
    game:Turn();
    CheckEqual(false, game:Percepts(red).blocked._new);
    Do(game, red, "move", { direction = "left" });
    game:Turn();
    CheckEqual(true, game:Percepts(red).blocked._new);
end

function tests.RadarSeesThreeColumnsUpToWhatIsInTheWay()
    local game, red = Game({ "H            E", "  #           ", "              ", " M1           " });
    Do(game, red, "radar", { switch = "on" });
    Do(game, red, "radar-power", { setting = 5 });
    game:Turn();
    local percepts = game:Percepts(red);
    CheckEqual(2, percepts["radar-distance"]);
    CheckEqual("left", percepts.radar.missiles[1].position);
    CheckEqual(0, percepts.radar.missiles[1].distance);
    CheckEqual(1, #percepts.radar.obstacle);
    CheckEqual("center", percepts.radar.obstacle[1].position);
    CheckEqual(2, percepts.radar.obstacle[1].distance);
    -- The open cells: right at distance 0, and left, right and center at distance 1.
    CheckEqual(4, #percepts.radar.open);
end

function tests.RadarEndsAtItsPower()
    local game, red = Game({ "H            E", "              ", "              ", "  1           " });
    Do(game, red, "radar", { switch = "on" });
    Do(game, red, "radar-power", { setting = 2 });
    game:Turn();
    CheckEqual(2, game:Percepts(red)["radar-distance"]);
    CheckEqual(6, #game:Percepts(red).radar.open);
    Do(game, red, "radar", { switch = "off" });
    game:Turn();
    CheckEqual(nil, game:Percepts(red).radar);
end

function tests.WhoIsSeenByRadarNoticesFromWhere()
    local game, red, blue = Game({ "H            E", "  2           ", "              ", "  1           " });
    Do(game, red, "radar", { switch = "on" });
    Do(game, red, "radar-power", { setting = 5 });
    game:Turn();
    CheckEqual("blue", game:Percepts(red).radar.tank[1].color);
    CheckEqual(2, game:Percepts(red).radar.tank[1].distance);
    CheckEqual("yes", game:Percepts(blue).rwaves.backward);
    CheckEqual("no", game:Percepts(blue).rwaves.forward);
    CheckEqual("no", game:Percepts(red).rwaves.forward);
end

function tests.AMissileThatComesIsSensedAcrossTheBoardButNotThroughOthers()
    local game, red, blue = Game({ "H 2          E", "              ", "              ", "              ", "  1           " });
    Do(game, red, "fire");
    game:Turn();
    CheckEqual("yes", game:Percepts(blue).incoming.backward);
    CheckEqual("no", game:Percepts(blue).incoming.forward);
    CheckEqual("no", game:Percepts(red).incoming.forward);
    game.cells[3][3] = "obstacle";
    game:LookAround();
    CheckEqual("no", game:Percepts(blue).incoming.backward);
end

function tests.SmellTellsOfTheNearestTankThroughWalls()
    local game, red = Game(Wide("  1#  2   3   "));
    CheckEqual("blue", game:Percepts(red).smell.color);
    CheckEqual(4, game:Percepts(red).smell.distance);
    local alone, one = Game(Wide("  1           "));
    CheckEqual("none", alone:Percepts(one).smell.color);
    CheckEqual("none", alone:Percepts(one).smell.distance);
end

function tests.SoundTellsTheWayToWhoHasMoved()
    local game, red, blue = Game({ "H            E", "              ", "  1#2         " });
    game:Turn();
    CheckEqual("silent", game:Percepts(red).sound);
    Do(game, blue, "rotate", { direction = "left" });
    game:Turn();
    -- The way leads around the obstacle, so its first step is ahead of this tank, which faces north.
    CheckEqual("forward", game:Percepts(red).sound);
    CheckEqual("silent", game:Percepts(blue).sound);
    local far, one, two = Game(Wide("1       2     "));
    Do(far, two, "rotate", { direction = "left" });
    far:Turn();
    CheckEqual("silent", far:Percepts(one).sound);
end

function tests.ATankPerceivesItselfAndAllScores()
    local game, red, blue = Game(Wide("  1 2         "));
    blue.score = 7;
    local percepts = game:Percepts(red);
    CheckEqual(3, percepts.x);
    CheckEqual(3, percepts.y);
    CheckEqual("north", percepts.direction);
    CheckEqual("red", percepts["my-color"]);
    CheckEqual(7, percepts["current-score"].blue);
    CheckEqual(0, percepts["current-score"].red);
    CheckEqual(1, percepts.clock);
    CheckEqual("yes", percepts.resurrect);
    game:Turn();
    CheckEqual(2, game:Percepts(red).clock);
end

-- The game ------------------------------------------------------------------------------------------------------------

function tests.CommandsThatAreNoneSayWhy()
    local game, red = Game(Wide("  1           "));
    CheckEqual("unknown-command", Do(game, red, "jump"));
    CheckEqual("no-such-direction", Do(game, red, "move", { direction = "north" }));
    CheckEqual("no-such-direction", Do(game, red, "rotate", { direction = "backward" }));
    CheckEqual("no-such-switch", Do(game, red, "radar", { switch = "maybe" }));
    CheckEqual("no-such-switch", Do(game, red, "shields"));
    CheckEqual(nil, Do(game, red, "fire"));
    CheckEqual("once-a-turn", Do(game, red, "fire"));
end

function tests.AHundredTurnsWithoutAShotBringAllTanksElsewhere()
    local game, red, blue = Game(Wide("  1 2         "));
    red.health = 300;
    for _ = 1, 99 do
        game:Turn();
    end
    CheckPlace(red, 3, 3);
    game:Turn();
    CheckPlace(red, 2, 1);
    CheckEqual(1000, red.health);
    CheckEqual(0, red.score);
    Check(blue.x ~= 5 or blue.y ~= 3);
end

function tests.AShotKeepsTheBoardAsItIs()
    local game, red = Game(Wide("  1 2         "));
    for turn = 1, 120 do
        if (turn == 60) then
            Do(game, red, "fire");
        end
        game:Turn();
    end
    CheckPlace(red, 3, 3);
end

function tests.FiftyPointsEndTheGame()
    local game, red = Game(Wide("  1           "));
    red.score = 49;
    game:Turn();
    Check(not game.isOver);
    red.score = 50;
    game:Turn();
    Check(game.isOver);
end

function tests.AFaultyMapSaysWhere()
    local _, message = pcall(TankSoarRules.new, { map = { "..", "." } });
    Check(message:find("line 1 of the map has '.'", 1, true), message);
    _, message = pcall(TankSoarRules.new, { map = { "  ", " " } });
    Check(message:find("line 2 of the map has 1 cells", 1, true), message);
end

-- Maps and commands ---------------------------------------------------------------------------------------------------

local function Reachable(game)
    local seen, edge, count = {}, {}, 0;
    local function Visit(x, y)
        local name = x .. "," .. y;
        if (game:ContentAt(x, y) ~= "obstacle" and not seen[name]) then
            seen[name] = true;
            count = count + 1;
            edge[#edge + 1] = { x = x, y = y };
        end
    end
    for x = 1, game.width do
        if (count == 0) then
            Visit(x, 1);
        end
    end
    while (#edge > 0) do
        local cell = table.remove(edge);
        for _, step in pairs(GridBoard.Steps) do
            Visit(cell.x + step.x, cell.y + step.y);
        end
    end
    return count;
end

local function Open(game)
    local count = 0;
    for y = 1, game.height do
        for x = 1, game.width do
            count = count + (game:ContentAt(x, y) ~= "obstacle" and 1 or 0);
        end
    end
    return count;
end

function tests.EachCellOfEachBoardIsInReach()
    for name in pairs(TankSoarMaps.named) do
        local game = TankSoarRules.new({ map = name });
        CheckEqual(14, game.width);
        CheckEqual(14, game.height);
        CheckEqual(Open(game), Reachable(game));
    end
    for _ = 1, 20 do
        local game = TankSoarRules.new({ map = "random" });
        CheckEqual(Open(game), Reachable(game));
        Check(Open(game) < 14 * 14 - 20, "a board without obstacles");
        for y = 1, 14 do
            for x = 1, 14 do
                CheckEqual(game:ContentAt(x, y) == "obstacle", game:ContentAt(15 - x, 15 - y) == "obstacle");
            end
        end
    end
end

function tests.TheSameChanceMakesTheSameBoard()
    local function Seeded()
        local state = 7;
        return function(most)
            state = (state * 16807) % 2147483647;
            return most and state % most + 1 or state / 2147483647;
        end
    end
    CheckEqual(table.concat(TankSoarMaps.Random(Seeded()), "|"), table.concat(TankSoarMaps.Random(Seeded()), "|"));
end

function tests.ABoardThatThereIsNotIsRefused()
    local ok, message = pcall(TankSoarRules.new, { map = "hall" });
    Check(not ok);
    CheckEqual("there is no map 'hall'; there are: random, clumps, halls, lanes", message);
end

function tests.WhatIsWrongWithACommandIsSaid()
    local game, red = Game(Wide("  1           "));
    local reason, details = Do(game, red, "sheilds", { switch = "on" });
    CheckEqual("unknown-command", reason);
    CheckEqual("there is no command ^sheilds", details.text);
    reason, details = Do(game, red, "radar", { switch = "maybe" });
    CheckEqual("no-such-switch", reason);
    CheckEqual("^switch of ^radar is maybe", details.text);
    reason, details = Do(game, red, "radar-power", { setting = 2.5 });
    CheckEqual("no-such-setting", reason);
    CheckEqual("^setting of ^radar-power is 2.5: it takes a whole number", details.text);
    reason, details = Do(game, red, "radar-power", { setting = 99 });
    CheckEqual(nil, reason);
    CheckEqual("a radar's power is 0 to 14: it is set to 14", details.text);
    game:Turn();
    CheckEqual(14, red.radarPower);
    red.missiles = 0;
    reason, details = Do(game, red, "fire", { weapon = "missile" });
    CheckEqual(nil, reason);
    CheckEqual("it has no missiles", details.text);
end

function tests.ATankThatRotatesDoesNotMoveHoweverItSaysSo()
    local game, red = Game(Wide("  1           "));
    CheckEqual(nil, Do(game, red, "move", { direction = "right" }));
    local reason, details = Do(game, red, "rotate", { direction = "left" });
    CheckEqual(nil, reason);
    CheckEqual("move", details.drops);
    CheckEqual("move-or-rotate", details.reason);
    game:Turn();
    CheckPlace(red, 3, 3);
    CheckEqual("west", red.direction);
    Do(game, red, "rotate", { direction = "left" });
    CheckEqual("move-or-rotate", (Do(game, red, "move", { direction = "right" })));
end

function tests.NobodyIsToldOfAMissileOfItsOwn()
    local game, red, blue = Game({ "H            E", "              ", "1             ", "              ", "2             " });
    game.flying = { { owner = red, x = 1, y = 4, direction = "north", age = 0, number = 1 } };
    game:LookAround();
    CheckEqual("no", game:Percepts(red).incoming.backward);
    game.flying[1].owner = blue;
    game:LookAround();
    CheckEqual("yes", game:Percepts(red).incoming.backward);
end

function tests.WhereTwoSoundsAreEquallyNearChanceTakesOne()
    local heard = {};
    for chance = 1, 4 do
        local game, red, blue, yellow = Game(Wide("   2 1 3      "), { random = Always(chance), facing = { "north" } });
        blue.hasMoved, yellow.hasMoved = true, true;
        game:LookAround();
        heard[game:Percepts(red).sound] = true;
    end
    Check(heard.left and heard.right);
end

RunTests(tests);
