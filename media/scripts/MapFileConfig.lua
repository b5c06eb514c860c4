-- SPDX-License-Identifier: BSD-2-Clause
-- Parses files with lines `path.to.key = value;`: the later maps of Soar2D, the descriptions of their objects, and its
-- configurations. MapFile.lua uses the results.
MapFileConfig = {};

local kDeepest = 20;

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

-- The text that the pattern matches here, or nil.
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

-- Blanks in a word are ignored, unless it is quoted: `d a t a` is data.
local function TakeWord(reader)
    local quoted = Take(reader, '"[^"\n]*"');
    if (quoted) then
        return quoted:sub(2, -2);
    end
    local word = Take(reader, "[%w_%.%-/:][%w_%.%-/: \t]*");
    return word and (word:gsub("[ \t]", ""));
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

-- Everything that is set between two braces, by its full name ("cells.size").
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

local function Word(found, name)
    local given = found[name];
    return given and type(given.value) == "string" and given.value or nil, given and given.line;
end

-- The text of a file, and the name under which it was found: the given path, or its end, because the folders of Soar2D
-- may be missing. If there is no such file: nil, and the error for the shortest name.
function MapFileConfig.Find(read, path)
    local problem;
    while (path) do
        local ok, text = pcall(read, path);
        if (ok) then
            return text, path;
        end
        problem, path = text, path:match("^[^/]*/(.+)$");
    end
    return problem;
end

-- Objects -------------------------------------------------------------------------------------------------------------

-- The properties of each object that a file describes.
local function ReadObjects(text, name)
    local objects = {};
    for key, given in pairs(Parse(text, name)) do
        local id, property = key:match("^objects%.([^.]+)%.(.+)$");
        if (id and type(given.value) == "string") then
            objects[id] = objects[id] or {};
            objects[id][property] = given.value;
        end
    end
    return objects;
end

-- The objects of the file that the map names, if it exists; otherwise the usual ones of such maps.
local function ObjectsOf(found, name, read, known)
    local file = Word(found, "objects_file");
    if (file) then
        local folder = name:match("^.*/") or "";
        local text, at = MapFileConfig.Find(read, folder .. file);
        if (at) then
            return ReadObjects(text, at);
        end
    end
    return known;
end

-- Maps ----------------------------------------------------------------------------------------------------------------

-- The ids in a cell such as g-h; "-" alone means none.
local function IdsOf(cell)
    local ids = {};
    for id in cell:gmatch("[^%-]+") do
        ids[#ids + 1] = id;
    end
    return ids;
end

local function RowOf(name, given)
    if (type(given.value) ~= "table") then
        error(name .. ":" .. given.line .. ": a row is a list of cells, as [w, -, w]", 0);
    end
    local row = { line = given.line, cells = {} };
    for x, cell in ipairs(given.value) do
        row.cells[x] = IdsOf(cell);
    end
    return row;
end

function MapFileConfig.Read(text, name, read, known)
    local found = Parse(text, name);
    local size, sizeLine = Word(found, "cells.size");
    local list = found.objects and type(found.objects.value) == "table" and found.objects;
    local map = {
        name = name, size = tonumber(size), sizeLine = sizeLine, sizeName = "cells.size", rows = {},
        randomWalls = Word(found, "cells.random_walls") == "true",
        randomFood = Word(found, "cells.random_food") == "true",
        order = list and list.value or {}, orderLine = list and list.line,
        objects = ObjectsOf(found, name, read, known)
    };
    for key, given in pairs(found) do
        local y = tonumber(key:match("^cells%.rows%.(%d+)$"));
        if (y) then
            map.rows[y + 1] = RowOf(name, given);
        end
    end
    return map;
end

-- Configurations ------------------------------------------------------------------------------------------------------

-- The file of the map that a configuration names; nil if this is not a configuration.
function MapFileConfig.MapOf(text, name, game)
    local found = Parse(text, name);
    local map = Word(found, "general.map");
    local played, line = Word(found, "general.game");
    if (map and played and played ~= game) then
        error(name .. ":" .. line .. ": this is a configuration of " .. played .. ", not of " .. game, 0);
    end
    return map;
end

-- Adds the rules of the configuration. `numbers`: the names of settings by their names in the configuration. Penalties
-- are negative there.
function MapFileConfig.AddSettings(text, name, numbers, settings)
    local found = Parse(text, name);
    for key, setting in pairs(numbers) do
        local given, line = Word(found, key);
        local number = tonumber(given);
        if (found[key] and not number) then
            error(name .. ":" .. (line or found[key].line) .. ": " .. key .. " is a number", 0);
        end
        settings[setting] = number and (setting:find("Score") and number or math.abs(number));
    end
end
