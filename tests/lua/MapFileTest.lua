-- SPDX-License-Identifier: BSD-2-Clause
-- Map and configuration files of Soar2D.
require "Check";
require "EatersMaps";
require "EatersRules";
require "MapFile";
require "TankSoarRules";

local tests = {};

local kSmall = [[
objects_file = "objects/objects.txt";   # Not there: the objects that such maps have always had.
objects = [b, n, w, x];
cells {
    size = 4;
    rows {
        0 = [w, w, w, w];
        1 = [w, n, b, w];
        2 = [w, n, -, w];
        3 = [w, w, w, w];
    }
}
]]

local kXml = [[
<?xml version="1.0"?>
<!-- As the earlier maps are. -->
<map>
  <cell-object name="wall"><property name="id" value="wall" /><property name="block" value="true" /></cell-object>
  <cell-object name="apple" consumable="true" updatable="true">
    <property name="id" value="normalfood" />
    <property name="points" value="7" />
    <property name="edible" value="true" />
    <apply><points /></apply>
    <update><decay /></update>
  </cell-object>
  <cell-object name="chest">
    <property name="box" value="true" />
    <property name="color" value='green' />
    <apply><points /><property name="status" value="open" /><property name="points" value="20" /></apply>
  </cell-object>
  <cell-object name="mat"><property name="move-apply" value="true" /><property name="points" value="2" /></cell-object>
  <cells world-size="4" random-walls="false" random-food="false">
    <row><cell><object>wall</object></cell><cell><object>wall</object></cell><cell><object>wall</object></cell><cell><object>wall</object></cell></row>
    <row>
      <cell row="1" col="0"><object>wall</object></cell>
      <cell><object>apple</object></cell>
      <cell><object>chest</object><object>mat</object></cell>
      <cell><object>wall</object></cell>
    </row>
    <row><cell><object>wall</object></cell><cell /><cell></cell><cell><object>wall</object></cell></row>
    <row><cell><object>wall</object></cell><cell><object>wall</object></cell><cell><object>wall</object></cell><cell><object>wall</object></cell></row>
  </cells>
</map>
]]

local function Load(files, name, game)
    return MapFile.Load(function(file) return files[file] or error("no " .. file, 0); end, name, game or EatersMaps);
end

local function CheckRefused(text, wanted, game)
    local ok, message = pcall(Load, { ["a.txt"] = text }, "a.txt", game);
    Check(not ok, "it is accepted");
    Check(message:find(wanted, 1, true), message);
end

local function GameOf(text)
    local settings = Load({ ["a.txt"] = text }, "a.txt");
    settings.random = function() return 1; end;
    return EatersRules.new(settings);
end

function tests.TestRowsBecomeLinesWithoutTheWallsAround()
    local settings = Load({ ["a.txt"] = kSmall }, "a.txt");
    CheckEqual("*.|* ", table.concat(settings.map, "|"));
    CheckEqual(nil, settings.randomWalls);
end

function tests.TestABoardIsPlayed()
    local game = GameOf(kSmall);
    CheckEqual("wall", game:ContentAt(0, 1));
    CheckEqual("normalfood", game:ContentAt(1, 1));
    CheckEqual("bonusfood", game:ContentAt(2, 1));
    local count, points = game:FoodLeft();
    CheckEqual(3, count);
    CheckEqual(20, points);
end

function tests.TestRandomFoodFillsWhatIsEmpty()
    CheckEqual(4, (GameOf(kSmall:gsub("size = 4;", "size = 4; random_food = true;")):FoodLeft()));
end

function tests.TestAMapMayBeLeftToChance()
    local settings = Load({ ["a.txt"] = "cells { size = 10; random_walls = true; random_food = true; }" }, "a.txt");
    CheckEqual(8, settings.width);
    CheckEqual(8, settings.height);
    Check((EatersRules.new(settings):FoodLeft()) > 20);
end

function tests.TestBoxesTreatsAndFoodThatDecaysAreRead()
    local game = GameOf(kSmall:gsub("b, n, w, x", "1, p, dn, w, x"):gsub("w, n, b, w", "w, dn, 1-p, w"):gsub("w, n, %-", "w, -, -"));
    CheckEqual("normalfood", game:ContentAt(1, 1));
    CheckEqual(1, game.foodOf.dn.decay);
    CheckEqual("green", game.boxes[1].color);
    CheckEqual(20, game.boxes[1].points);
    CheckEqual(2, game.boxes[1].x);
    CheckEqual(1, game.treats[1].points);
    CheckEqual(1, game.treats[1].y);
end

function tests.TestAFileMayDescribeObjects()
    local files = {
        ["a.txt"] = kSmall:gsub("w, n, b, w", "w, k, b, w"):gsub("b, n, w, x", "b, k, n, w"),
        ["objects.txt"] = [[
            objects.w { name = wall; block = true; }
            objects.n { name = normalfood; edible = true; apply.points = 5; }
            objects.b { name = bonusfood; edible = true; apply.points = 10; }
            objects.k { name = cake; edible = true; id = cake; apply.points = 50; update.decay = 10; }]]
    };
    local game = EatersRules.new(Load(files, "a.txt"));
    CheckEqual("cake", game:ContentAt(1, 1));
    CheckEqual(50, game:WorthAt(1, 1));
end

function tests.TestAMapOfXmlIsPlayed()
    local game = GameOf(kXml);
    CheckEqual("normalfood", game:ContentAt(1, 1));
    CheckEqual(7, game:WorthAt(1, 1));
    CheckEqual("empty", game:ContentAt(1, 2));
    CheckEqual("wall", game:ContentAt(0, 0));
    CheckEqual(20, game.boxes[1].points);
    CheckEqual("box", game.boxes[1].id);
    CheckEqual(2, game.treats[1].points);
    game:Turn();
    CheckEqual(6, game:WorthAt(1, 1));
end

function tests.TestFaultsInXmlAreToldWithTheirLine()
    CheckRefused(kXml:gsub("<cell />", "<cell>"), "a.txt:26: </row> ends the <cell> of line 26");
    CheckRefused(kXml:gsub('world%-size="4"', 'world-size="few"'), "a.txt:18: world-size of <cells> is a whole number from 3");
    CheckRefused(kXml:gsub('world%-size="4"', 'world-size="5"'), "a.txt:19: a row has 5 cells, as the size of the map says, and this one has 4");
    CheckRefused(kXml:gsub("<object>apple</object>", "<object>pear</object>"), "a.txt:22: the object 'pear' is not described");
    CheckRefused(kXml:gsub('<property name="move%-apply" value="true" />', ""), "a.txt:23: the object 'mat' is nothing that these rules have: walls, food");
    CheckRefused(kXml:gsub("</map>", ""), "has no end");
    CheckRefused(kXml .. "<map/>", "more text after the end of <map>");
    CheckRefused(kXml:gsub("'green'", "green"), "a.txt:14: expected a value in quotes after value=");
    CheckRefused("<soar2d><map/></soar2d>", "a.txt:1: this is a <soar2d>; a map of Soar2D is a <map>");
    CheckRefused(("<a>"):rep(50), "more than 20 elements within each other");
    CheckRefused("<map/>", "a.txt:1: world-size of <cells> is a whole number");
    CheckRefused("<", "a.txt:1: expected an element");
end

local kTanks = [[
cells { size = 4; rows {
    0 = [r, r, r, r];
    1 = [r, g-h, g-t, r];
    2 = [r, g, g-m, r];
    3 = [r, r, r, r]; } }
]]

function tests.TestABoardOfTanksIsPlayed()
    local settings = Load({ ["a.txt"] = kTanks }, "a.txt", TankSoarMaps.file);
    CheckEqual("H#| M", table.concat(settings.map, "|"));
    settings.mostPacks, settings.random = 0, function() return 1; end;
    CheckEqual("health", TankSoarRules.new(settings):ContentAt(1, 1));
    CheckRefused(kTanks:gsub("g%-m", "h-m"), "a.txt:4: two things in one cell, 'h-m'", TankSoarMaps.file);
    CheckRefused(kTanks:gsub("g%-m", "g-x"), "a.txt:4: the object 'x' is nothing that these rules have: ground", TankSoarMaps.file);
end

function tests.TestAConfigurationNamesItsMapAndTheNumbersOfTheRules()
    local files = {
        ["eaters.cnf"] = 'general { game = "eaters"; map = "config/maps/a.txt"; }\neaters.wall_penalty = -7;\neaters . vis ion = 3;\n',
        ["tanks.cnf"] = "general.game = tanksoar;\ngeneral.map = t.txt;\nterminals.winning_score = 20;\ntanksoar { max_missiles = 3; collision_penalty = -50; }\n",
        ["a.txt"] = kSmall, ["t.txt"] = kTanks
    };
    local settings = Load(files, "eaters.cnf");
    CheckEqual(2, #settings.map);
    CheckEqual(7, settings.wallPenalty);
    CheckEqual(3, settings.vision);
    settings = Load(files, "tanks.cnf", TankSoarMaps.file);
    CheckEqual(20, settings.winningScore);
    CheckEqual(3, settings.missiles);
    CheckEqual(50, settings.collisionDamage);
    files["eaters.cnf"] = 'general.map = "a.txt";\n\neaters.vision = far;\n';
    local ok, message = pcall(Load, files, "eaters.cnf");
    Check(not ok);
    CheckEqual("eaters.cnf:3: eaters.vision is a number", message);
end

function tests.TestAConfigurationOfAnotherGameIsRefused()
    local files = { ["a.cnf"] = 'general.map = "a.txt";\ngeneral.game = "tanksoar";\n', ["a.txt"] = kSmall };
    local ok, message = pcall(Load, files, "a.cnf");
    Check(not ok);
    CheckEqual("a.cnf:2: this is a configuration of tanksoar, not of eaters", message);
end

function tests.TestWhatTheRulesDoNotHaveIsRefused()
    CheckRefused(kSmall:gsub("w, n, b, w", "w, n, q, w"), "a.txt:7: the object 'q' is not described");
    CheckRefused(kSmall:gsub("w, n, b, w", "w, n, x, w"), "a.txt:7: the object 'x' is nothing that these rules have: walls, food");
    CheckRefused(kSmall:gsub("w, n, b, w", "w, n, n-b, w"), "a.txt:7: two things in one cell, 'n-b', where these rules have one");
    CheckRefused("objects = [q];\ncells { size = 10; random_walls = true; random_food = true; }", "a.txt:1: the object 'q' is not described");
end

function tests.TestBlanksWithinWordsDoNotCount()
    CheckEqual("*.|* ", table.concat(Load({ ["a.txt"] = kSmall:gsub("cells {", "ce lls {"):gsub("size = 4", "si ze\n= 4") }, "a.txt").map, "|"));
end

function tests.TestFaultsAreToldWithTheirLine()
    CheckRefused(kSmall:gsub("size = 4;", "size = 4"), "a.txt:5: expected ; and found 'r'");
    CheckRefused(kSmall:gsub("size = 4", "size = none"), "a.txt:4: cells.size is a whole number from 3 to 102");
    CheckRefused(kSmall:gsub("w, n, b, w", "w, n, w"), "a.txt:7: a row has 4 cells");
    CheckRefused(kSmall:gsub("%[w, n, b, w%]", "w"), "a.txt:7: a row is a list of cells");
    CheckRefused(kSmall:gsub("w, n, b, w", "n, n, b, w"), "the map has no wall at both ends of row 1");
    CheckRefused(kSmall:gsub("0 = %[w, w", "0 = [w, n"), "the map has no walls all around");
    CheckRefused(kSmall:gsub("1 = %[w, n, b, w%];", ""), "row 1 of the map is missing");
    CheckRefused(kSmall .. "}", "expected a name and found '}'");
    CheckRefused(kSmall:sub(1, -3), "expected } and found the end of the file");
    CheckRefused("a = [b; c];", "a.txt:1: expected ] and found ';'");
    CheckRefused(("a {"):rep(50), "more than 20 braces within each other");
    CheckRefused("", "a.txt:1: cells.size");
end

RunTests(tests);
