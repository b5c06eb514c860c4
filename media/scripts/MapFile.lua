-- SPDX-License-Identifier: BSD-2-Clause
-- Reads the maps (.txt, .emap, .tmap) and configurations (.cnf) of Soar2D, the program with which Eaters and TankSoar
-- were played, so that its boards can be used here. docs/eaters.md says which parts are used.
--
-- MapFileConfig.lua and MapFileXml.lua read the two formats of a map. Each returns
--     { name, size, sizeLine, randomWalls, randomFood, order = { ids }, objects = { [id] = object }, rows = { row } }
-- where an object contains its properties as words, and a row { line, lines, cells } the ids of the contents of each
-- cell. Line numbers are for messages: of the row, and of its cells if they have their own lines.
require "MapFileConfig";
require "MapFileXml";

MapFile = {};

local kLargest = 102;

local function Fail(map, line, what)
    error(map.name .. ":" .. (line or 1) .. ": " .. what, 0);
end

-- Converts the object to this game: game.Sort(object, id, foods) returns { sign, food, other }, where `food` is the
-- meaning of the sign, and `other` a thing that is stored separately. Nil if the rules have no such thing.
local function Sort(map, id, line, game, known)
    local object = map.objects[id];
    if (not object) then
        Fail(map, line, "the object '" .. id .. "' is not described");
    end
    if (known[id] == nil) then
        known[id] = game.Sort(object, id, known.foods) or false;
        if (known[id] and known[id].food) then
            table.insert(known.foods, known[id].food);
        end
    end
    return known[id];
end

-- The sign of a cell, and its other contents.
local function ReadCell(map, line, ids, game, known)
    local sign, others = nil, {};
    for _, id in ipairs(ids) do
        local own = Sort(map, id, line, game, known)
            or Fail(map, line, "the object '" .. id .. "' is nothing that these rules have: " .. game.known);
        if (own.other) then
            others[#others + 1] = own.other;
        elseif (own.sign ~= " ") then
            if (sign) then
                Fail(map, line, "two things in one cell, '" .. table.concat(ids, "-") .. "', where these rules have one");
            end
            sign = own.sign;
        end
    end
    return sign or " ", others;
end

-- Boards have walls around them here, too, but these are not part of a map.
local function WithoutEdge(map, lines)
    local wall = ("#"):rep(#lines);
    if (lines[1] ~= wall or lines[#lines] ~= wall) then
        error(map.name .. ": the map has no walls all around", 0);
    end
    local inner = {};
    for y = 2, #lines - 1 do
        if (not lines[y]:find("^#.*#$")) then
            error(map.name .. ": the map has no wall at both ends of row " .. (y - 1), 0);
        end
        inner[y - 1] = lines[y]:sub(2, -2);
    end
    return inner;
end

local function ReadRows(map, game, settings, known)
    local lines = {};
    for y = 1, map.size do
        local row = map.rows[y];
        if (not row) then
            error(map.name .. ": row " .. (y - 1) .. " of the map is missing", 0);
        elseif (#row.cells ~= map.size) then
            Fail(map, row.line, "a row has " .. map.size .. " cells, as the size of the map says, and this one has "
                 .. #row.cells);
        end
        local signs = {};
        for x, ids in ipairs(row.cells) do
            local sign, others = ReadCell(map, row.lines and row.lines[x] or row.line, ids, game, known);
            signs[x] = sign;
            for _, other in ipairs(others) do
                game.Keep(settings, other, x - 1, y - 1);
            end
        end
        lines[y] = table.concat(signs);
    end
    settings.map = WithoutEdge(map, lines);
end

local function Settings(map, game)
    if (not map.size or map.size % 1 ~= 0 or map.size < 3 or map.size > kLargest) then
        Fail(map, map.sizeLine, map.sizeName .. " is a whole number from 3 to " .. kLargest);
    end
    local settings = { randomWalls = map.randomWalls or nil, randomFood = map.randomFood or nil };
    local known = { foods = {} };
    for _, id in ipairs(map.order) do -- Random food is of these.
        Sort(map, id, map.orderLine, game, known);
    end
    if (next(map.rows) or not (map.randomWalls and map.randomFood)) then
        ReadRows(map, game, settings, known);
    else
        settings.width, settings.height = map.size - 2, map.size - 2;
    end
    settings.foods = #known.foods > 0 and known.foods or nil;
    return settings;
end

local function ReadMap(read, name, game)
    local text = read(name);
    local map = text:find("^%s*<") and MapFileXml.Read(text, name) or MapFileConfig.Read(text, name, read, game.objects);
    return Settings(map, game);
end

-- The settings in a file. `read` returns the text of a file by its name. `game` contains its name in configurations
-- (`name`), the objects of maps without a description (`objects`), and the functions that convert objects (Sort, Keep,
-- known). The map of a configuration is searched in the folder of the configuration. Errors contain file and line.
function MapFile.Load(read, name, game)
    local text = read(name);
    local map = not text:find("^%s*<") and MapFileConfig.MapOf(text, name, game.name);
    if (not map) then
        return ReadMap(read, name, game);
    end
    local problem, found = MapFileConfig.Find(read, map);
    if (not found) then
        error(name .. ": its map: " .. problem, 0);
    end
    local settings = ReadMap(read, found, game);
    MapFileConfig.AddSettings(text, name, game.numbers, settings);
    return settings;
end

-- The settings of a scenario, combined with those of its `mapFile`, if any.
function MapFile.Settings(sandbox, settings, game)
    if (not settings.mapFile) then
        return settings;
    end
    local function Read(name)
        return Sandbox.ReadText(sandbox, name);
    end
    local all = MapFile.Load(Read, settings.mapFile, game);
    for name, value in pairs(settings) do
        all[name] = value;
    end
    return all;
end
