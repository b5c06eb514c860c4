-- SPDX-License-Identifier: BSD-2-Clause
-- The boards of TankSoar: our own, by name; random ones; and the conversion of the objects in Soar2D's map files, for
-- MapFile.lua.

TankSoarMaps = { named = {} };

-- Open, with groups of rocks.
TankSoarMaps.named.clumps = {
    "              ",
    " #  #    #  # ",
    "              ",
    "   ##    ##   ",
    " #          # ",
    "     #  #     ",
    "  #   ##   #  ",
    "  #   ##   #  ",
    "     #  #     ",
    " #          # ",
    "   ##    ##   ",
    "              ",
    " #  #    #  # ",
    "              "
};

-- Four halls around a court, with doors for one tank.
TankSoarMaps.named.halls = {
    "    #    #    ",
    "    #    #    ",
    "              ",
    "    #    #    ",
    "## ###  ### ##",
    "    #    #    ",
    "  #   ##   #  ",
    "  #   ##   #  ",
    "    #    #    ",
    "## ###  ### ##",
    "    #    #    ",
    "              ",
    "    #    #    ",
    "    #    #    "
};

-- Long lanes with few connections: tanks are seen from far away.
TankSoarMaps.named.lanes = {
    "              ",
    " ##### # #### ",
    "              ",
    " # ####### ## ",
    "              ",
    " #### # ##### ",
    "              ",
    "              ",
    " ##### # #### ",
    "              ",
    " ## ####### # ",
    "              ",
    " #### # ##### ",
    "              "
};

-- By chance -----------------------------------------------------------------------------------------------------------

local kSide, kTries = 14, 60;

-- Whether all open cells are connected.
local function IsConnected(isRock)
    local open, first = 0, nil;
    for cell = 0, kSide * kSide - 1 do
        if (not isRock[cell]) then
            open, first = open + 1, first or cell;
        end
    end
    local seen, edge, reached = { [first] = true }, { first }, 0;
    while (#edge > 0) do
        local cell = table.remove(edge);
        local x = cell % kSide;
        reached = reached + 1;
        for _, beside in ipairs({ x > 0 and cell - 1, x < kSide - 1 and cell + 1, cell - kSide, cell + kSide }) do
            if (beside and beside >= 0 and beside < kSide * kSide and not isRock[beside] and not seen[beside]) then
                seen[beside] = true;
                edge[#edge + 1] = beside;
            end
        end
    end
    return reached == open;
end

-- A board that is symmetric, with all open cells connected. `random` is like math.random.
function TankSoarMaps.Random(random)
    local isRock = {};
    for _ = 1, kTries do
        local cell = random(kSide * kSide) - 1;
        local opposite = kSide * kSide - 1 - cell;
        if (not isRock[cell]) then
            isRock[cell], isRock[opposite] = true, true;
            if (not IsConnected(isRock)) then
                isRock[cell], isRock[opposite] = nil, nil;
            end
        end
    end
    local lines = {};
    for y = 0, kSide - 1 do
        local signs = {};
        for x = 0, kSide - 1 do
            signs[x + 1] = isRock[y * kSide + x] and "#" or " ";
        end
        lines[y + 1] = table.concat(signs);
    end
    return lines;
end

-- The lines of a map: the map itself, or the one with that name.
function TankSoarMaps.Lines(map, random)
    if (type(map) ~= "string") then
        return map;
    elseif (map == "random") then
        return TankSoarMaps.Random(random);
    end
    local names = {};
    for name in pairs(TankSoarMaps.named) do
        names[#names + 1] = name;
    end
    table.sort(names);
    return TankSoarMaps.named[map]
        or error("there is no map '" .. map .. "'; there are: random, " .. table.concat(names, ", "), 0);
end

-- Files ---------------------------------------------------------------------------------------------------------------

TankSoarMaps.file = {
    name = "tanksoar", known = "ground, rocks, trees, chargers and missiles",
    numbers = {
        ["tanksoar.max_missiles"] = "missiles", ["tanksoar.max_energy"] = "mostEnergy",
        ["tanksoar.max_health"] = "mostHealth", ["tanksoar.collision_penalty"] = "collisionDamage",
        ["tanksoar.max_missile_packs"] = "mostPacks", ["tanksoar.missile_pack_respawn_chance"] = "packChance",
        ["tanksoar.shield_energy_usage"] = "shieldEnergy", ["tanksoar.missile_hit_award"] = "hitAward",
        ["tanksoar.missile_hit_penalty"] = "hitPenalty", ["tanksoar.frag_award"] = "destroyAward",
        ["tanksoar.frag_penalty"] = "destroyPenalty", ["tanksoar.max_sound_distance"] = "soundReach",
        ["tanksoar.missile_reset_threshold"] = "quietTurns", ["terminals.winning_score"] = "winningScore"
    },
    objects = {
        g = { name = "ground" }, r = { name = "rocks", block = "true" }, t = { name = "trees", block = "true" },
        e = { name = "energy", charger = "true", id = "energy" }, h = { name = "health", charger = "true", id = "health" },
        m = { name = "missiles" }, M = { name = "missile" }, x = { name = "explosion" },
        ["radar-north"] = { name = "radar-north" }, ["radar-east"] = { name = "radar-east" },
        ["radar-south"] = { name = "radar-south" }, ["radar-west"] = { name = "radar-west" }
    }
};

function TankSoarMaps.file.Sort(object)
    if (object.block == "true") then
        return { sign = "#" };
    elseif (object.charger == "true" and (object.id == "energy" or object.id == "health")) then
        return { sign = object.id == "energy" and "E" or "H" };
    elseif (object.name == "missiles" or object.name == "ground") then
        return { sign = object.name == "missiles" and "M" or " " };
    end
end
