-- SPDX-License-Identifier: BSD-2-Clause
-- Parses the earlier maps of Soar2D, which are XML: <map> with a <cell-object> for each kind of object, and <cells>
-- with rows. MapFile.lua uses the results.
MapFileXml = {};

local kDeepest = 20;
local kEntities = { lt = "<", gt = ">", amp = "&", quot = '"', apos = "'" };

local function Fail(reader, what)
    error(reader.name .. ":" .. reader.line .. ": " .. what, 0);
end

-- XML -----------------------------------------------------------------------------------------------------------------

local function Plain(text)
    return (text:gsub("&(%w+);", kEntities));
end

-- Advances to `last`, and counts lines.
local function Pass(reader, last)
    reader.line = reader.line + select(2, reader.text:sub(reader.at, last):gsub("\n", ""));
    reader.at = last + 1;
end

-- The captures of the pattern here; nil if it does not match.
local function Take(reader, pattern)
    local _, last, captured = reader.text:find("^" .. pattern, reader.at);
    if (last) then
        Pass(reader, last);
        return captured or "";
    end
end

-- Comments, declarations, and text between <? and ?>.
local function SkipNotes(reader)
    while (Take(reader, "%s+") or Take(reader, "<%?.-%?>") or Take(reader, "<!%-%-.-%-%->") or Take(reader, "<![^>]*>")) do
    end
end

local function ReadAttributes(reader, element)
    while (true) do
        Take(reader, "%s+");
        local name = Take(reader, "([%w_:%.%-]+)%s*=%s*");
        if (not name) then
            return;
        end
        local value = Take(reader, '"([^"]*)"') or Take(reader, "'([^']*)'");
        if (not value) then
            Fail(reader, "expected a value in quotes after " .. name .. "=");
        end
        element.attributes[name] = Plain(value);
    end
end

-- An element { name, line, attributes, text } with its children in the list part.
local function ReadElement(reader, depth)
    local element = { line = reader.line, attributes = {}, text = "" };
    element.name = Take(reader, "<([%w_:%.%-]+)") or Fail(reader, "expected an element, as <map>");
    if (depth > kDeepest) then
        Fail(reader, "more than " .. kDeepest .. " elements within each other");
    end
    ReadAttributes(reader, element);
    if (Take(reader, "/>")) then
        return element;
    elseif (not Take(reader, ">")) then
        Fail(reader, "expected > at the end of <" .. element.name);
    end
    while (true) do
        SkipNotes(reader);
        local closed = Take(reader, "</([%w_:%.%-]+)%s*>");
        if (closed == element.name) then
            return element;
        elseif (closed) then
            Fail(reader, "</" .. closed .. "> ends the <" .. element.name .. "> of line " .. element.line);
        elseif (reader.text:find("^<", reader.at)) then
            element[#element + 1] = ReadElement(reader, depth + 1);
        else
            local text = Take(reader, "([^<]+)");
            if (not text) then
                Fail(reader, "<" .. element.name .. "> of line " .. element.line .. " has no end");
            end
            element.text = element.text .. Plain(text):match("^(.-)%s*$");
        end
    end
end

local function Parse(text, name)
    local reader = { text = text, name = name, at = 1, line = 1 };
    SkipNotes(reader);
    local root = ReadElement(reader, 1);
    SkipNotes(reader);
    if (reader.at <= #text) then
        Fail(reader, "more text after the end of <" .. root.name .. ">");
    end
    return root;
end

-- Maps ----------------------------------------------------------------------------------------------------------------

-- The effects of using an object, with the names of the later maps.
local function AddApply(object, apply)
    for _, child in ipairs(apply) do
        if (child.name == "property") then
            object["apply.properties." .. (child.attributes.name or "")] = child.attributes.value;
            -- The points for opening a box are its own points.
            if (child.attributes.name == "points") then
                object["apply.points"] = child.attributes.value;
            end
        elseif (child.name == "points") then
            object["apply.points"] = object["apply.points"] or object.points;
        elseif (child.name == "reward") then
            object["apply.reward"], object["apply.reward.positive"] = "true", child.attributes.quantity;
        elseif (child.name == "reward-info") then
            object["apply.reward-info"] = "true";
            object["apply.reward-info.code"] = child[1] and child[1].name == "use-open-code" and "true" or nil;
        else
            object["apply." .. child.name] = "true";
        end
    end
end

local function ReadObject(element)
    local object = { name = element.attributes.name };
    for _, child in ipairs(element) do
        if (child.name == "property" and child.attributes.name) then
            object[child.attributes.name] = child.attributes.value;
        end
    end
    for _, child in ipairs(element) do
        if (child.name == "apply") then
            AddApply(object, child);
        elseif (child.name == "update") then
            for _, update in ipairs(child) do
                object["update." .. update.name] = "1";
            end
        end
    end
    return object;
end

local function ReadCells(map, cells)
    map.sizeLine = cells.line;
    map.size = tonumber(cells.attributes["world-size"]);
    map.randomWalls = cells.attributes["random-walls"] == "true";
    map.randomFood = cells.attributes["random-food"] == "true";
    for y, element in ipairs(cells) do
        local row = { line = element.line, cells = {}, lines = {} };
        for x, cell in ipairs(element) do
            row.cells[x], row.lines[x] = {}, cell.line;
            for i, object in ipairs(cell) do
                row.cells[x][i] = object.text;
            end
        end
        map.rows[y] = row;
    end
end

function MapFileXml.Read(text, name)
    local root = Parse(text, name);
    if (root.name ~= "map") then
        error(name .. ":" .. root.line .. ": this is a <" .. root.name .. ">; a map of Soar2D is a <map>", 0);
    end
    local map = { name = name, sizeName = "world-size of <cells>", rows = {}, order = {}, objects = {} };
    for _, element in ipairs(root) do
        if (element.name == "cell-object" and element.attributes.name) then
            local object = ReadObject(element);
            map.objects[object.name] = object;
            map.order[#map.order + 1] = object.name;
        elseif (element.name == "cells") then
            ReadCells(map, element);
        end
    end
    return map;
end
