-- SPDX-License-Identifier: BSD-2-Clause
-- Converts the objects of Soar2D's map files to Eaters, for MapFile.lua.

EatersMaps = {
    name = "eaters", known = "walls, food, boxes and what brings points to those who come by",
    -- Keys of configurations that correspond to settings.
    numbers = {
        ["eaters.vision"] = "vision", ["eaters.wall_penalty"] = "wallPenalty", ["eaters.jump_penalty"] = "jumpPenalty",
        ["eaters.low_probability"] = "aloneChance", ["eaters.high_probability"] = "besideChance"
    }
};

local function Food(name, points, decay)
    return { name = name, id = name, edible = "true", ["apply.points"] = points, ["apply.remove"] = "true",
             ["update.decay"] = decay };
end

local function Box(name, id, color, properties)
    properties.name, properties.id, properties.box, properties.shape = name, id, "true", "square";
    properties.color = color;
    return properties;
end

-- The objects of maps without a file that describes them.
EatersMaps.objects = {
    w = { name = "wall", block = "true", id = "wall" },
    n = Food("normalfood", "5"), b = Food("bonusfood", "10"), nn = Food("normalfood", "-1"),
    dn = Food("normalfood", "5", "1"), db = Food("bonusfood", "10", "1"),
    ["1"] = Box("box1", "box", "green", { ["apply.points"] = "20" }),
    ["2"] = Box("box2", "box", "orange", { ["apply.points"] = "10" }),
    p = { name = "permafood", ["move-apply"] = "true", ["apply.points"] = "1" },
    i = Box("infobox", "info-box", nil, { ["apply.reward-info"] = "true" }),
    r = Box("rewardbox", "box", nil, { ["apply.reward"] = "true", ["apply.reward.positive"] = "10",
                                       ["apply.reward.negative"] = "1" }),
    x = { name = "explosion", explosion = "true" }
};

-- Characters for food in the lines of a map.
local kSigns = ".*abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

-- `foods`: the foods found so far.
local function SortFood(object, id, foods)
    local sign = kSigns:sub(#foods + 1, #foods + 1);
    if (sign == "") then
        return nil;
    end
    return { sign = sign, food = {
        name = id, content = object.id or object.name or id, sign = sign,
        points = tonumber(object["apply.points"] or object.points) or 0, decay = tonumber(object["update.decay"])
    } };
end

local function SortBox(object)
    return { other = { list = "boxes", thing = {
        id = object.id or "box", color = object.color, shape = object.shape,
        points = tonumber(object["apply.points"]),
        isInfo = object["apply.reward-info"] == "true", needsCode = object["apply.reward-info.code"] == "true",
        reward = object["apply.reward"] == "true" and (tonumber(object["apply.reward.positive"]) or 0) or nil,
        wrongCode = tonumber(object["apply.reward.negative"])
    } } };
end

-- The meaning of an object: a character with its food, or a thing that is stored separately from the lines of the map.
function EatersMaps.Sort(object, id, foods)
    if (object.block == "true") then
        return { sign = "#" };
    elseif (object.edible == "true") then
        return SortFood(object, id, foods);
    elseif (object.box == "true") then
        return SortBox(object);
    elseif (object["move-apply"] == "true") then
        return { other = { list = "treats", thing = { points = tonumber(object["apply.points"] or object.points) or 0 } } };
    end
end

function EatersMaps.Keep(settings, other, x, y)
    local thing = { x = x, y = y };
    for name, value in pairs(other.thing) do
        thing[name] = value;
    end
    settings[other.list] = settings[other.list] or {};
    table.insert(settings[other.list], thing);
end
