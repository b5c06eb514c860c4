-- SPDX-License-Identifier: BSD-2-Clause
-- The rules of Eaters, and nothing else: no bodies, no pictures, no minds. Eaters on a board of cells eat the food that
-- lies there. docs/eaters.md describes the game; tests/lua/EatersRulesTest.lua states each rule.
--
-- A game goes turn by turn:
--     local game = EatersRules.new({ random = math.random });
--     local eater = game:Join("red");
--     game:Command(eater, "move", { direction = "north" });    -- nil, or why not
--     game:Turn();
--     game:Percepts(eater)                                     -- what its mind perceives
require "GridBoard";

EatersRules = {};
EatersRules.__index = EatersRules;

local kFoods = { "normalfood", "bonusfood" };
-- What stands for what in a map that is given as lines of text. Digits are where eaters begin.
local kSigns = { ["#"] = "wall", ["."] = "normalfood", ["*"] = "bonusfood", [" "] = "empty" };

EatersRules.Defaults = {
    width = 15, height = 15,                -- Cells, without the walls around them.
    vision = 2,                             -- How many cells away an eater sees.
    points = { normalfood = 5, bonusfood = 10 },
    wallPenalty = 5, jumpPenalty = 5,
    aloneChance = 0.25, besideChance = 0.75 -- That a cell becomes a wall: without, and with, one beside it.
};

-- The board -----------------------------------------------------------------------------------------------------------

-- What lies at a place: "wall", "empty", or a food. Beyond the edge there are walls.
function EatersRules:ContentAt(x, y)
    local row = self.cells[y];
    return row and row[x] or "wall";
end

local function Set(game, x, y, content)
    game.cells[y][x] = content;
end

local function IsWall(game, x, y)
    return game:ContentAt(x, y) == "wall";
end

function EatersRules:EaterAt(x, y)
    for _, eater in ipairs(self.eaters) do
        if (eater.x == x and eater.y == y) then
            return eater;
        end
    end
end

-- Walls are straight: none has another at its corner, so that there are neither bends nor dead ends. None stands at
-- the edge of the board.
local function BuildWalls(game)
    for y = 2, game.height - 1 do
        for x = 2, game.width - 1 do
            local atCorner, beside = false, false;
            for dy = -1, 1 do
                for dx = -1, 1 do
                    local isWall = (dx ~= 0 or dy ~= 0) and IsWall(game, x + dx, y + dy);
                    atCorner = atCorner or (isWall and dx ~= 0 and dy ~= 0);
                    beside = beside or (isWall and (dx == 0 or dy == 0));
                end
            end
            local chance = beside and game.besideChance or game.aloneChance;
            if (not atCorner and game.random() < chance) then
                Set(game, x, y, "wall");
            end
        end
    end
end

-- Where nothing lies yet.
local function LayFood(game)
    for y = 1, game.height do
        for x = 1, game.width do
            if (game:ContentAt(x, y) == "empty") then
                Set(game, x, y, kFoods[game.random(#kFoods)]);
            end
        end
    end
end

-- Random walls and food fill a board that has no map.
local function EmptyMap(game)
    game.randomWalls, game.randomFood = true, true;
    local lines = {};
    for y = 1, game.height do
        lines[y] = (" "):rep(game.width);
    end
    return lines;
end

-- A game with these settings; EatersRules.Defaults are the others. `random` is like math.random. `map`: lines of text;
-- `randomWalls` and `randomFood` add to it.
function EatersRules.new(settings)
    local game = setmetatable({ cells = {}, starts = {}, eaters = {}, turn = 0, collisions = {} }, EatersRules);
    GridBoard.Settle(game, EatersRules.Defaults, settings);
    game.map = game.map or EmptyMap(game);
    GridBoard.Read(game, game.map, kSigns, "empty", "# . *");
    if (game.randomWalls) then
        BuildWalls(game);
    end
    if (game.randomFood) then
        LayFood(game);
    end
    return game;
end

-- How much food is left, and how many points that is.
function EatersRules:FoodLeft()
    local count, points = 0, 0;
    for y = 1, self.height do
        for x = 1, self.width do
            local worth = self.points[self.cells[y][x]];
            if (worth) then
                count, points = count + 1, points + worth;
            end
        end
    end
    return count, points;
end

local function FreeCell(game)
    local free = {};
    for y = 1, game.height do
        for x = 1, game.width do
            if (not IsWall(game, x, y) and not game:EaterAt(x, y)) then
                free[#free + 1] = { x = x, y = y };
            end
        end
    end
    if (#free == 0) then
        error("the board has no free cell for another eater");
    end
    return free[game.random(#free)];
end

-- Eaters --------------------------------------------------------------------------------------------------------------

-- Puts an eater on the board; the food in its cell is gone, and nobody gets points for it.
function EatersRules:Join(color)
    local start = self.starts[#self.eaters + 1] or FreeCell(self);
    local eater = {
        color = color, x = start.x, y = start.y, score = 0, direction = "north",
        hasMoved = true -- Since its mind perceived the last time.
    };
    Set(self, eater.x, eater.y, "empty");
    self.eaters[#self.eaters + 1] = eater;
    return eater;
end

-- Takes a command for this turn. Nil if it is one that an eater can do, otherwise a word that says why not.
function EatersRules:Command(eater, name, parameters)
    if (name == "dont-eat") then
        eater.fasts = true;
        return nil;
    end
    if (name ~= "move" and name ~= "jump") then
        return "unknown-command";
    end
    local direction = parameters.direction;
    if (name == "move" and direction == "none") then
        return nil;
    end
    if (not GridBoard.Steps[direction]) then
        return "no-such-direction";
    end
    if (eater.wish) then
        return "one-move-a-turn";
    end
    eater.wish = { direction = direction, cells = name == "jump" and 2 or 1 };
    return nil;
end

-- A turn --------------------------------------------------------------------------------------------------------------

-- Into a wall nobody goes: it costs points. A jump goes over whatever is in between, and costs points, too.
local function Move(game, eater)
    local wish = eater.wish;
    if (not wish) then
        return;
    end
    local step = GridBoard.Steps[wish.direction];
    local x, y = eater.x + wish.cells * step.x, eater.y + wish.cells * step.y;
    eater.direction = wish.direction;
    if (IsWall(game, x, y)) then
        eater.score = eater.score - game.wallPenalty;
        eater.hitWall = true;
        return;
    end
    if (wish.cells == 2) then
        eater.score = eater.score - game.jumpPenalty;
    end
    eater.x, eater.y = x, y;
    eater.hasMoved = true;
end

local function Eat(game, eater)
    local worth = game.points[game:ContentAt(eater.x, eater.y)];
    if (worth and not eater.fasts) then
        eater.score = eater.score + worth;
        Set(game, eater.x, eater.y, "empty");
    end
end

-- The groups of eaters that are in one cell.
local function FindCollisions(game)
    local groups, done = {}, {};
    for i, eater in ipairs(game.eaters) do
        local group = { eater };
        for j = i + 1, #game.eaters do
            local other = game.eaters[j];
            if (not done[other] and other.x == eater.x and other.y == eater.y) then
                group[#group + 1] = other;
                done[other] = true;
            end
        end
        if (#group > 1 and not done[eater]) then
            groups[#groups + 1] = group;
        end
    end
    return groups;
end

-- Their scores become the same, without what is left over; a debt is not shared. They go on from other places.
local function Collide(game, group)
    game.collisions[#game.collisions + 1] = { x = group[1].x, y = group[1].y };
    local sum = 0;
    for _, eater in ipairs(group) do
        sum = sum + eater.score;
    end
    for _, eater in ipairs(group) do
        if (sum > 0) then
            eater.score = math.floor(sum / #group);
        end
        local place = FreeCell(game);
        eater.x, eater.y = place.x, place.y;
        eater.hasMoved, eater.wasThrown = true, true;
        Eat(game, eater);
    end
end

-- All move, all eat, in the order in which they joined; then those who are in one cell collide.
function EatersRules:Turn()
    self.turn = self.turn + 1;
    self.collisions = {};
    for _, eater in ipairs(self.eaters) do
        eater.hitWall, eater.wasThrown = false, false;
        Move(self, eater);
    end
    for _, eater in ipairs(self.eaters) do
        Eat(self, eater);
    end
    for _, group in ipairs(FindCollisions(self)) do
        Collide(self, group);
    end
    for _, eater in ipairs(self.eaters) do
        eater.wish, eater.fasts = nil, nil;
    end
    self.isOver = self:FoodLeft() == 0;
end

-- Percepts ------------------------------------------------------------------------------------------------------------

local function CellOf(game, x, y, isNew)
    local cell = { content = game:ContentAt(x, y), _new = isNew };
    local other = game:EaterAt(x, y);
    if (other) then
        -- Food that nobody ate lies there besides.
        cell.content = cell.content == "empty" and "eater" or { "eater", cell.content };
        cell["eater-color"], cell["eater-score"] = other.color, other.score;
    end
    return cell;
end

-- What the mind of an eater perceives: itself, and the cells around it, linked by their directions. When it has moved,
-- each cell's content is new, even where it is the same as before.
function EatersRules:Percepts(eater)
    local far, cells = self.vision, {};
    for dy = -far, far do
        cells[dy] = {};
        for dx = -far, far do
            cells[dy][dx] = CellOf(self, eater.x + dx, eater.y + dy, eater.hasMoved);
        end
    end
    for dy = -far, far do
        for dx = -far, far do
            for direction, step in pairs(GridBoard.Steps) do
                local row = cells[dy + step.y];
                cells[dy][dx][direction] = row and row[dx + step.x];
            end
        end
    end
    eater.hasMoved = false;
    return {
        eater = { name = eater.color, score = eater.score, x = eater.x, y = eater.y, direction = eater.direction },
        ["my-location"] = cells[0][0],
        random = self.random()
    };
end
