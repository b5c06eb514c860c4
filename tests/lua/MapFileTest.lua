-- SPDX-License-Identifier: BSD-2-Clause
-- Map and configuration files of Soar2D.
require "Check";
require "EatersRules";
require "MapFile";

local tests = {};
local kSigns = { ["-"] = " ", g = " ", w = "#", n = ".", b = "*", known = "w, n, b and -" };

local kSmall = [[
objects_file = "objects/objects.txt";   # Not read.
objects = [b, n, w, x];
cells {
    size = 4;
    rows {
        0 = [w, w, w, w];
        1 = [w, n, b, w];
        2 = [w, g-n, -, w];
        3 = [w, w, w, w];
    }
}
]]

local function Load(files, name)
    return MapFile.Load(function(file) return files[file] or error("no " .. file, 0); end, name, "eaters", kSigns);
end

local function CheckRefused(text, wanted)
    local ok, message = pcall(Load, { ["a.txt"] = text }, "a.txt");
    Check(not ok, "it is accepted");
    Check(message:find(wanted, 1, true), message);
end

function tests.TestRowsBecomeLinesWithoutTheWallsAround()
    local settings = Load({ ["a.txt"] = kSmall }, "a.txt");
    CheckEqual(".*|. ", table.concat(settings.map, "|"));
    CheckEqual(nil, settings.randomWalls);
end

function tests.TestABoardIsPlayed()
    local settings = Load({ ["a.txt"] = kSmall }, "a.txt");
    local game = EatersRules.new(settings);
    CheckEqual("wall", game:ContentAt(0, 1));
    CheckEqual("bonusfood", game:ContentAt(2, 1));
    CheckEqual(3, (game:FoodLeft()));
end

function tests.TestRandomFoodFillsWhatIsEmpty()
    local settings = Load({ ["a.txt"] = kSmall:gsub("size = 4;", "size = 4; random_food = true;") }, "a.txt");
    CheckEqual(4, (EatersRules.new(settings):FoodLeft()));
end

function tests.TestAMapMayBeLeftToChance()
    local settings = Load({ ["a.txt"] = "cells { size = 10; random_walls = true; random_food = true; }" }, "a.txt");
    CheckEqual(8, settings.width);
    CheckEqual(8, settings.height);
    Check((EatersRules.new(settings):FoodLeft()) > 20);
end

function tests.TestAConfigurationNamesItsMap()
    local files = {
        ["eaters.cnf"] = 'general { game = "eaters"; map = "config/maps/a.txt"; }\nterminals.winning_score = 20;\n',
        ["a.txt"] = kSmall
    };
    local settings = Load(files, "eaters.cnf");
    CheckEqual(2, #settings.map);
    CheckEqual(20, settings.winningScore);
end

function tests.TestAConfigurationOfAnotherGameIsRefused()
    local files = { ["a.cnf"] = 'general.map = "a.txt";\ngeneral.game = "tanksoar";\n', ["a.txt"] = kSmall };
    local ok, message = pcall(Load, files, "a.cnf");
    Check(not ok);
    CheckEqual("a.cnf:2: this is a configuration of tanksoar, not of eaters", message);
end

function tests.TestWhatTheRulesDoNotHaveIsRefused()
    CheckRefused(kSmall:gsub("g%-n", "1-p"), "a.txt:8: the cell '1-p' is nothing that these rules have: w, n, b and -");
    CheckRefused("objects = [db, w, x];\ncells { size = 10; random_walls = true; random_food = true; }",
        "a.txt:1: the object 'db' is nothing that these rules have");
    CheckRefused(kSmall:gsub("g%-n", "n-b"), "a.txt:8: the cell 'n-b'");
end

function tests.TestFaultsAreToldWithTheirLine()
    CheckRefused(kSmall:gsub("size = 4;", "size = 4"), "a.txt:5: expected ; and found 'r'");
    CheckRefused(kSmall:gsub("size = 4", "size = none"), "a.txt:4: cells.size is a whole number from 3 to 102");
    CheckRefused(kSmall:gsub("w, n, b, w", "w, n, w"), "a.txt:7: a row is a list of 4 cells");
    CheckRefused(kSmall:gsub("w, n, b, w", "n, n, b, w"), "the map has no wall at both ends of row 1");
    CheckRefused(kSmall:gsub("1 = %[w, n, b, w%];", ""), "row 1 of the map is missing");
    CheckRefused(kSmall .. "}", "expected a name and found '}'");
    CheckRefused(kSmall:sub(1, -3), "expected } and found the end of the file");
    CheckRefused("a = [b c];", "a.txt:1: expected ] and found 'c'");
    CheckRefused(("a {"):rep(50), "more than 20 braces within each other");
    CheckRefused("", "a.txt:1: cells.size");
end

RunTests(tests);
