-- SPDX-License-Identifier: BSD-2-Clause
-- What the rules of all games on a board of cells have in common: directions, and reading a board.
GridBoard = {};

-- Clockwise. y counts from the first line of a map to the last.
GridBoard.Directions = { "north", "east", "south", "west" };
GridBoard.Steps = {
    north = { x = 0, y = -1 }, east = { x = 1, y = 0 }, south = { x = 0, y = 1 }, west = { x = -1, y = 0 }
};

-- The direction so many quarters to the right.
function GridBoard.Turned(direction, quarters)
    for i, name in ipairs(GridBoard.Directions) do
        if (name == direction) then
            return GridBoard.Directions[(i - 1 + quarters) % 4 + 1];
        end
    end
end

-- Gives a game these settings, and for those that are not named the defaults.
function GridBoard.Settle(game, defaults, settings)
    for name, value in pairs(defaults) do
        game[name] = value;
    end
    for name, value in pairs(settings or {}) do
        game[name] = value;
    end
    game.random = game.random or math.random;
end

-- Fills game.cells[y][x] from lines of text. `signs`: what each character means; digits are places to begin at
-- (game.starts), where the cell is `empty`. `known` names the characters for messages.
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
