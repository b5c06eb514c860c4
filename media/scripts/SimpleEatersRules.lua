-- SPDX-License-Identifier: BSD-2-Clause
-- The rules of Simple Eaters, without bodies, pictures and minds: one eater that moves forward or turns on a small
-- board. Used like EatersRules.lua. docs/eaters.md describes the game; tests/lua/SimpleEatersRulesTest.lua states each
-- rule.
require "GridBoard";

SimpleEatersRules = {};
SimpleEatersRules.__index = SimpleEatersRules;

-- y counts to the north here.
SimpleEatersRules.Steps = {
    north = { x = 0, y = 1 }, east = { x = 1, y = 0 }, south = { x = 0, y = -1 }, west = { x = -1, y = 0 }
};
local kSides = { front = 0, right = 1, back = 2, left = 3 };
local kSigns = { ["#"] = "wall", [" "] = "empty", r = "red", p = "purple", g = "green", b = "blue" };

SimpleEatersRules.Defaults = {
    -- The first line is the northernmost; an eater begins at the 1.
    map = { "p1rg", "prr#", "p#rb" },
    orientation = "east",
    points = { red = 5, purple = 10, green = 15, blue = 20 },
    wallPenalty = 10, timePenalty = 1
};

-- The content of a cell, counted from 0 in the south-west; cells outside of the board are walls.
function SimpleEatersRules:ContentAt(x, y)
    local row = self.cells[y];
    return row and row[x] or "wall";
end

local function ReadMap(game, lines)
    game.height, game.width = #lines, #lines[1];
    for i, line in ipairs(lines) do
        if (#line ~= game.width) then
            error("line " .. i .. " of the map has " .. #line .. " cells, and the first has " .. game.width);
        end
        local y = game.height - i;
        game.cells[y] = {};
        for x = 0, game.width - 1 do
            local sign = line:sub(x + 1, x + 1);
            if (sign == "1") then
                game.start = { x = x, y = y };
            elseif (not kSigns[sign]) then
                error("line " .. i .. " of the map has '" .. sign .. "': a cell is # r p g b 1 or a space");
            end
            game.cells[y][x] = sign == "1" and "empty" or kSigns[sign];
        end
    end
    if (not game.start) then
        error("the map has no 1, where the eater begins");
    end
end

function SimpleEatersRules.new(settings)
    local game = setmetatable({ cells = {}, turn = 1, score = 0, views = 0 }, SimpleEatersRules);
    GridBoard.Settle(game, SimpleEatersRules.Defaults, settings);
    ReadMap(game, game.map);
    game.x, game.y = game.start.x, game.start.y;
    return game;
end

function SimpleEatersRules:FoodLeft()
    local count = 0;
    for y = 0, self.height - 1 do
        for x = 0, self.width - 1 do
            count = count + (self.points[self.cells[y][x]] and 1 or 0);
        end
    end
    return count;
end

-- The first command of a turn is used. Nil if it is possible, else the reason as a result of Sandbox_Command.
function SimpleEatersRules:Command(said, parameters)
    local name, reason, details = GridBoard.Understand({ forward = {}, rotate = {} }, said, parameters or {});
    if (not name) then
        return reason, details;
    elseif (self.wish) then
        return "one-command-a-turn", { text = "it has given ^" .. self.wish .. " in this turn" };
    end
    self.wish = name;
end

local function GoForward(game)
    local step = SimpleEatersRules.Steps[game.orientation];
    local x, y = game.x + step.x, game.y + step.y;
    local content = game:ContentAt(x, y);
    game.hitWall = content == "wall";
    if (game.hitWall) then
        game.score = game.score - game.wallPenalty;
        return;
    end
    game.x, game.y = x, y;
    game.score = game.score + (game.points[content] or 0);
    game.cells[y][x] = "empty";
end

function SimpleEatersRules:Turn()
    local before, wish = self.score, self.wish;
    self.turn, self.hitWall, self.wish = self.turn + 1, false, nil;
    self.hasGone = wish == "forward";
    if (wish == "forward") then
        GoForward(self);
    elseif (wish == "rotate") then
        self.orientation = GridBoard.Turned(self.orientation, 1);
    end
    if (wish) then
        self.score = self.score - self.timePenalty;
    end
    self.difference = self.score - before;
    self.isOver = self:FoodLeft() == 0 and self.x == self.start.x and self.y == self.start.y;
end

-- The percepts in two parts: those that the world removes and adds again in each turn, and those that it leaves
-- unchanged unless the eater has moved forward. Both are on the input link.
function SimpleEatersRules:Percepts()
    local isFirst = self.turn == 1;
    local percepts = {
        time = self.turn, score = self.score, ["score-diff"] = isFirst and "nil" or self.difference,
        orientation = self.orientation, x = self.x, y = self.y, ["food-remaining"] = self:FoodLeft(),
        _new = { "time", "score", "score-diff", "orientation", "front", "right", "back", "left", "food-remaining",
                 "finish", "task" }
    };
    for side, quarters in pairs(kSides) do
        local step = SimpleEatersRules.Steps[GridBoard.Turned(self.orientation, quarters)];
        percepts[side] = self:ContentAt(self.x + step.x, self.y + step.y);
    end
    for orientation, step in pairs(SimpleEatersRules.Steps) do
        percepts[orientation] = self:ContentAt(self.x + step.x, self.y + step.y);
    end
    if (self.hasGone or isFirst) then
        for _, name in ipairs({ "x", "y", "north", "east", "south", "west" }) do
            table.insert(percepts._new, name);
        end
    end
    percepts.finish = self.x == self.start.x and self.y == self.start.y and "here" or nil;
    percepts.task = self.isOver and "complete" or nil;
    return percepts;
end
