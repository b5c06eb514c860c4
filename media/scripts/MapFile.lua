-- SPDX-License-Identifier: BSD-2-Clause
-- Reads the map files (.txt) and configuration files (.cnf) of Soar2D, the program that Eaters and TankSoar were played
-- with, so that its boards can be played here. docs/eaters.md says what of them counts.
MapFile = {};

local kDeepest, kLargest = 20, 102;

local function Fail(reader, what)
    error(reader.name .. ":" .. reader.line .. ": " .. what, 0);
end

-- Text ----------------------------------------------------------------------------------------------------------------

local function SkipSpace(reader)
    while (true) do
        local first, last = reader.text:find("^%s+", reader.at);
        if (not first) then
            first, last = reader.text:find("^#[^\n]*", reader.at);
        end
        if (not first) then
            return;
        end
        reader.line = reader.line + select(2, reader.text:sub(first, last):gsub("\n", ""));
        reader.at = last + 1;
    end
end

-- What the pattern matches here, or nil.
local function Take(reader, pattern)
    SkipSpace(reader);
    local first, last = reader.text:find("^" .. pattern, reader.at);
    if (first) then
        reader.at = last + 1;
        return reader.text:sub(first, last);
    end
end

local function Expect(reader, sign)
    if (not Take(reader, "%" .. sign)) then
        local found = Take(reader, "[^%s]");
        Fail(reader, "expected " .. sign .. " and found " .. (found and ("'" .. found .. "'") or "the end of the file"));
    end
end

local function TakeWord(reader)
    local quoted = Take(reader, '"[^"\n]*"');
    return quoted and quoted:sub(2, -2) or Take(reader, "[%w_%.%-/:]+");
end

local function ReadValue(reader)
    if (not Take(reader, "%[")) then
        return TakeWord(reader) or Fail(reader, "expected a value");
    end
    local list = { line = reader.line };
    while (not Take(reader, "%]")) do
        list[#list + 1] = TakeWord(reader) or Fail(reader, "expected ] at the end of the list");
        if (not Take(reader, ",")) then
            Expect(reader, "]");
            break;
        end
    end
    return list;
end

-- All that is set between two braces, by its whole name ("cells.size").
local function ReadBlock(reader, prefix, found, depth)
    if (depth > kDeepest) then
        Fail(reader, "more than " .. kDeepest .. " braces within each other");
    end
    while (true) do
        local name = TakeWord(reader);
        if (not name) then
            return;
        end
        name = prefix .. name;
        if (Take(reader, "{")) then
            ReadBlock(reader, name .. ".", found, depth + 1);
            Expect(reader, "}");
        else
            Expect(reader, "=");
            local line = reader.line;
            found[name] = { value = ReadValue(reader), line = line };
            Expect(reader, ";");
        end
    end
end

local function Parse(text, name)
    local reader = { text = text, name = name, at = 1, line = 1 };
    local found = {};
    ReadBlock(reader, "", found, 1);
    SkipSpace(reader);
    if (reader.at <= #text) then
        Fail(reader, "expected a name and found '" .. text:sub(reader.at, reader.at) .. "'");
    end
    return found;
end

-- Maps ----------------------------------------------------------------------------------------------------------------

-- The sign of our maps for a cell of theirs, such as "w" or "g-h". `signs`: by their names.
local function SignOf(cell, signs)
    local sign = signs["-"];
    for part in cell:gmatch("[^%-]+") do
        local own = signs[part];
        if (not own or (sign ~= signs["-"] and own ~= signs["-"])) then
            return nil;
        end
        sign = own ~= signs["-"] and own or sign;
    end
    return sign;
end

local function ReadRow(map, row, size, signs)
    local at = map.name .. ":" .. row.line .. ": ";
    if (type(row.value) ~= "table" or #row.value ~= size) then
        error(at .. "a row is a list of " .. size .. " cells, as cells.size says", 0);
    end
    local line = {};
    for x, cell in ipairs(row.value) do
        line[x] = SignOf(cell, signs) or
            error(at .. "the cell '" .. cell .. "' is nothing that these rules have: " .. signs.known, 0);
    end
    return table.concat(line);
end

-- Boards have walls around them here, too, but they are no part of a map.
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

local function ReadMap(map, signs)
    local settings = {};
    for _, name in ipairs({ "random_walls", "random_food" }) do
        local given = map.found["cells." .. name];
        settings[name == "random_walls" and "randomWalls" or "randomFood"] = given and given.value == "true" or nil;
    end
    local objects = map.found.objects;
    for _, object in ipairs(settings.randomFood and objects and type(objects.value) == "table" and objects.value or {}) do
        if (not signs[object] and object ~= "x") then -- That is an explosion.
            error(map.name .. ":" .. objects.line .. ": the object '" .. object ..
                "' is nothing that these rules have: " .. signs.known, 0);
        end
    end
    local given = map.found["cells.size"];
    local size = given and tonumber(given.value);
    if (not size or size % 1 ~= 0 or size < 3 or size > kLargest) then
        error(map.name .. ":" .. (given and given.line or 1) .. ": cells.size is a whole number from 3 to " .. kLargest, 0);
    end
    local lines = {};
    for y = 1, size do
        local row = map.found["cells.rows." .. (y - 1)];
        if (not row and not (settings.randomWalls and settings.randomFood)) then
            error(map.name .. ": row " .. (y - 1) .. " of the map is missing", 0);
        end
        lines[y] = row and ReadRow(map, row, size, signs);
    end
    if (#lines == size) then
        settings.map = WithoutEdge(map, lines);
    else
        settings.width, settings.height = size - 2, size - 2;
    end
    return settings;
end

-- The settings that a file stands for. `read` returns the text of a file by its name; `game` is its name in
-- configuration files. A configuration's map is looked for beside it. Errors name file and line.
function MapFile.Load(read, name, game, signs)
    local map = { name = name, found = Parse(read(name), name) };
    local mapName = map.found["general.map"];
    if (not mapName) then
        return ReadMap(map, signs);
    end
    local played = map.found["general.game"];
    if (played and played.value ~= game) then
        error(name .. ":" .. played.line .. ": this is a configuration of " .. tostring(played.value) .. ", not of " .. game, 0);
    end
    local beside = tostring(mapName.value):match("[^/]+$") or "";
    local settings = ReadMap({ name = beside, found = Parse(read(beside), beside) }, signs);
    local score = map.found["terminals.winning_score"];
    settings.winningScore = score and tonumber(score.value);
    return settings;
end

-- The settings of a scenario, with those that its `mapFile` stands for where it names one.
function MapFile.Settings(sandbox, settings, game, signs)
    if (not settings.mapFile) then
        return settings;
    end
    local function Read(name)
        return Sandbox.ReadText(sandbox, name);
    end
    local all = MapFile.Load(Read, settings.mapFile, game, signs);
    for name, value in pairs(settings) do
        all[name] = value;
    end
    return all;
end
