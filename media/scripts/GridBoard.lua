-- SPDX-License-Identifier: BSD-2-Clause
-- Common rules of all games on a board of cells: directions, and reading a board.
GridBoard = {};

-- Clockwise. y counts from the first line of a map to the last.
GridBoard.Directions = { "north", "east", "south", "west" };
GridBoard.Steps = {
    north = { x = 0, y = -1 }, east = { x = 1, y = 0 }, south = { x = 0, y = 1 }, west = { x = -1, y = 0 }
};

-- The direction after this number of quarter turns to the right.
function GridBoard.Turned(direction, quarters)
    for i, name in ipairs(GridBoard.Directions) do
        if (name == direction) then
            return GridBoard.Directions[(i - 1 + quarters) % 4 + 1];
        end
    end
end

-- The first of several things at a place, or nil.
function GridBoard.At(things, x, y)
    for _, thing in ipairs(things) do
        if (thing.x == x and thing.y == y) then
            return thing;
        end
    end
end

-- Commands ------------------------------------------------------------------------------------------------------------

local function SortedNames(list)
    local names = {};
    for name in pairs(list) do
        names[#names + 1] = name;
    end
    table.sort(names);
    return names;
end

-- The value of a command without its parameter.
local function OtherParameter(parameters)
    for _, name in ipairs(SortedNames(parameters)) do
        if (name ~= "status" and name ~= "reason" and name ~= "parameter") then
            return name;
        end
    end
end

-- Parses a command: returns its name and the value of its parameter in the form that the game uses (old agents write
-- capitals), or nil and the result for Sandbox_Command. `commands`: by name, the parameters of each:
--     { move = { direction = { "north", "south" } }, power = { setting = "number" }, wait = {} }
function GridBoard.Understand(commands, said, parameters)
    local name = said:lower();
    if (not commands[name]) then
        return nil, "unknown-command",
               { text = "there is no command ^" .. said, given = said, known = SortedNames(commands) };
    end
    local parameter, words = next(commands[name]);
    if (not parameter) then
        return name;
    end
    local reason, value = "no-such-" .. parameter, parameters[parameter];
    local isNumber = words == "number";
    if (value == nil) then
        local other = OtherParameter(parameters);
        return nil, reason, { text = "^" .. name .. " requires ^" .. parameter .. " ("
            .. (isNumber and "a whole number" or table.concat(words, ", ")) .. ")"
            .. (other and ", and has ^" .. other or "") };
    end
    local at = "^" .. parameter .. " of ^" .. name .. " is ";
    if (isNumber) then
        local number = tonumber(value);
        if (not number or number ~= math.floor(number)) then
            return nil, reason, { text = at .. tostring(value) .. ": it takes a whole number" };
        end
        return name, number;
    end
    for _, word in ipairs(words) do
        if (type(value) == "string" and value:lower() == word) then
            return name, word;
        end
    end
    value = type(value) == "table" and "an identifier" or tostring(value);
    return nil, reason, { text = at .. value, given = value, known = words };
end

-- Boards --------------------------------------------------------------------------------------------------------------

-- Sets these settings of a game, and the defaults for the others.
function GridBoard.Settle(game, defaults, settings)
    for name, value in pairs(defaults) do
        game[name] = value;
    end
    for name, value in pairs(settings or {}) do
        game[name] = value;
    end
    game.random = game.random or math.random;
end

-- Fills game.cells[y][x] from lines of text. `signs`: the meaning of each character; digits are starting places
-- (game.starts), whose cells are `empty`. `known` lists the characters for messages.
function GridBoard.Read(game, lines, signs, empty, known)
    game.height, game.width = #lines, #lines[1];
    for y, line in ipairs(lines) do
        if (#line ~= game.width) then
            error("line " .. y .. " of the map has " .. #line .. " cells, and the first has " .. game.width);
        end
        game.cells[y] = {};
        for x = 1, game.width do
            local sign = line:sub(x, x);
            local start = tonumber(sign);
            if (start) then
                game.starts[start] = { x = x, y = y };
            elseif (not signs[sign]) then
                error("line " .. y .. " of the map has '" .. sign .. "': a cell is " .. known .. " a digit or a space");
            end
            game.cells[y][x] = start and empty or signs[sign];
        end
    end
end
