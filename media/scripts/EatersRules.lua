-- SPDX-License-Identifier: BSD-2-Clause
-- The rules of Eaters, without bodies, pictures and minds. Eaters on a board of cells eat the food in the cells.
-- docs/eaters.md describes the game; tests/lua/EatersRulesTest.lua states each rule.
--
-- A game consists of turns:
--     local game = EatersRules.new({ random = math.random });
--     local eater = game:Join("red");
--     game:Command(eater, "move", { direction = "north" });    -- nil, or why not
--     game:Turn();
--     game:Percepts(eater)                                     -- what its mind perceives
require "EatersBoxes";
require "GridBoard";

EatersRules = {};
EatersRules.__index = EatersRules;

EatersRules.Defaults = {
    width = 15, height = 15,                 -- Cells, without the walls around them.
    vision = 2,                              -- How many cells away an eater sees.
    -- Foods: the character in a map, its appearance to eaters (the name, unless `content` is given), its points, and
    -- the points that it loses after each turn.
    foods = { { name = "normalfood", sign = ".", points = 5 }, { name = "bonusfood", sign = "*", points = 10 } },
    points = {},                             -- Other points, by the name of a food.
    wallPenalty = 5, jumpPenalty = 5,
    aloneChance = 0.25, besideChance = 0.75, -- Of a wall in a cell without, and with, a wall next to it.
    boxes = {}, treats = {}                  -- EatersBoxes.lua.
};

local kFour = { "north", "east", "south", "west" };
EatersRules.Commands = {
    move = { direction = { "north", "east", "south", "west", "none" } }, jump = { direction = kFour },
    ["dont-eat"] = {}, open = {}
};

-- The board -----------------------------------------------------------------------------------------------------------

-- The content of a cell: "wall", "empty", or the appearance of a food. Cells outside of the board are walls.
function EatersRules:ContentAt(x, y)
    local row = self.cells[y];
    local content = row and row[x] or "wall";
    return self.foodOf[content] and self.foodOf[content].content or content;
end

local function Set(game, x, y, content)
    game.cells[y][x] = content;
end

-- Removes the food from a cell. `cleared` lists the cells in which food was removed since the last turn began.
local function Clear(game, x, y)
    Set(game, x, y, "empty");
    game.cleared[#game.cleared + 1] = { x = x, y = y };
end

local function IsWall(game, x, y)
    local row = game.cells[y];
    return not row or not row[x] or row[x] == "wall";
end

-- Walls are straight: no wall touches the corner of another one, so there are no bends and no dead ends. No wall is at
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

-- Cells that are still empty.
local function LayFood(game)
    for y = 1, game.height do
        for x = 1, game.width do
            if (game.cells[y][x] == "empty" and not GridBoard.At(game.boxes, x, y)) then
                Set(game, x, y, game.foods[game.random(#game.foods)].name);
            end
        end
    end
end

-- Fills a board without a map with random walls and food.
local function EmptyMap(game)
    game.randomWalls, game.randomFood = true, true;
    local lines = {};
    for y = 1, game.height do
        lines[y] = (" "):rep(game.width);
    end
    return lines;
end

-- The meanings of the characters in a map of text lines. Digits are the places where eaters begin.
local function ReadFoods(game)
    local signs, known = { ["#"] = "wall", [" "] = "empty" }, { "#" };
    game.foodOf = {};
    for _, food in ipairs(game.foods) do
        local points = game.points[food.content or food.name] or food.points;
        game.foodOf[food.name] = { content = food.content or food.name, points = points, decay = food.decay or 0 };
        game.decays = game.decays or (food.decay or 0) > 0;
        signs[food.sign] = food.name;
        known[#known + 1] = food.sign;
    end
    return signs, table.concat(known, " ");
end

-- A game with these settings; the others are those of EatersRules.Defaults. `random` is like math.random. `map`: lines
-- of text; `randomWalls` and `randomFood` add to it.
function EatersRules.new(settings)
    local game = setmetatable({ cells = {}, starts = {}, eaters = {}, turn = 0, collisions = {}, cleared = {} },
                              EatersRules);
    GridBoard.Settle(game, EatersRules.Defaults, settings);
    game.map = game.map or EmptyMap(game);
    local signs, known = ReadFoods(game);
    GridBoard.Read(game, game.map, signs, "empty", known);
    EatersBoxes.Place(game);
    if (game.randomWalls) then
        BuildWalls(game);
    end
    if (game.randomFood) then
        LayFood(game);
    end
    return game;
end

-- The current points of the food in a cell; nil if there is none.
function EatersRules:WorthAt(x, y)
    local food = self.foodOf[self.cells[y][x]];
    return food and food.points - food.decay * self.turn;
end

-- The number of remaining foods, and their points.
function EatersRules:FoodLeft()
    local count, points = 0, 0;
    for y = 1, self.height do
        for x = 1, self.width do
            local worth = self:WorthAt(x, y);
            if (worth) then
                count, points = count + 1, points + worth;
            end
        end
    end
    return count, points;
end

-- An eater can jump from here, so that a beginner who learns to jump does not start between walls.
local function LeadsOn(game, x, y)
    for _, direction in ipairs(GridBoard.Directions) do
        local step = GridBoard.Steps[direction];
        if (not IsWall(game, x + 2 * step.x, y + 2 * step.y)) then
            return true;
        end
    end
    return false;
end

-- `isStart`: a cell with a way out, if there are any.
local function FreeCell(game, isStart)
    local free, good = {}, {};
    for y = 1, game.height do
        for x = 1, game.width do
            if (not IsWall(game, x, y) and not GridBoard.At(game.eaters, x, y)) then
                free[#free + 1] = { x = x, y = y };
                if (isStart and LeadsOn(game, x, y)) then
                    good[#good + 1] = free[#free];
                end
            end
        end
    end
    if (#free == 0) then
        error("the board has no free cell for another eater");
    end
    free = #good > 0 and good or free;
    return free[game.random(#free)];
end

-- Eaters --------------------------------------------------------------------------------------------------------------

-- Puts an eater on the board. The food in its cell is removed without points.
function EatersRules:Join(color)
    local start = self.starts[#self.eaters + 1] or FreeCell(self, true);
    local eater = {
        color = color, x = start.x, y = start.y, score = 0, direction = "north",
        hasMoved = true -- Since its mind perceived the last time.
    };
    Clear(self, eater.x, eater.y);
    self.eaters[#self.eaters + 1] = eater;
    return eater;
end

-- Accepts a command for this turn. Nil if an eater can execute it, else the reason as a result of Sandbox_Command.
function EatersRules:Command(eater, said, parameters)
    local name, direction, details = GridBoard.Understand(EatersRules.Commands, said, parameters);
    if (not name) then
        return direction, details;
    elseif (name == "dont-eat") then
        eater.fasts = true;
    elseif (name == "open") then
        eater.opens = true;
        eater.code = tonumber(parameters.code);
    elseif (direction ~= "none") then
        if (eater.wish) then
            return "one-move-a-turn", { text = "it has given a move or a jump in this turn" };
        end
        eater.wish = { direction = direction, cells = name == "jump" and 2 or 1 };
    end
end

-- A turn --------------------------------------------------------------------------------------------------------------

-- A move into a wall costs points and does not move the eater. A jump goes over anything in between, and costs points.
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
    local worth = game:WorthAt(eater.x, eater.y);
    if (worth and not eater.fasts) then
        eater.score = eater.score + worth;
        Clear(game, eater.x, eater.y);
    end
end

-- Removes food without points.
local function Rot(game)
    if (not game.decays) then
        return;
    end
    for y = 1, game.height do
        for x = 1, game.width do
            local food = game.foodOf[game.cells[y][x]];
            if (food and food.decay > 0 and game:WorthAt(x, y) <= 0) then
                Clear(game, x, y);
            end
        end
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

-- They get the same score, rounded down; a debt is not shared. They continue from other places.
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

-- All eaters move, eat and open boxes, in the order in which they joined; then eaters in the same cell collide.
function EatersRules:Turn()
    self.collisions, self.cleared = {}, {};
    for _, eater in ipairs(self.eaters) do
        eater.hitWall, eater.wasThrown = false, false;
        Move(self, eater);
    end
    for _, eater in ipairs(self.eaters) do
        EatersBoxes.Take(self, eater);
        Eat(self, eater);
        EatersBoxes.Open(self, eater);
    end
    for _, group in ipairs(FindCollisions(self)) do
        Collide(self, group);
    end
    for _, eater in ipairs(self.eaters) do
        eater.wish, eater.fasts, eater.opens, eater.code = nil, nil, nil, nil;
    end
    self.turn = self.turn + 1;
    Rot(self);
    self.foodLeft, self.pointsLeft = self:FoodLeft();
    self.isOver = self.foodLeft == 0 and EatersBoxes.AllOpen(self);
end

-- Percepts ------------------------------------------------------------------------------------------------------------

local function CellOf(game, x, y, other, isNew)
    local cell = { content = game:ContentAt(x, y), _new = isNew };
    local box = #game.boxes > 0 and GridBoard.At(game.boxes, x, y);
    if (box and cell.content == "empty") then
        cell.content = nil;
    end
    if (other) then
        -- There may also be food that was not eaten.
        local lies = cell.content ~= "empty" and cell.content or nil;
        cell.content = lies and { "eater", lies } or "eater";
        cell["eater-color"], cell["eater-score"] = other.color, other.score;
    end
    if (box) then
        cell[box.id or "box"] = EatersBoxes.Percepts(box, isNew);
    end
    return cell;
end

-- The percepts of an eater: itself, and the cells around it, linked by their directions. After it has moved, the
-- content of each cell is new, even if it is unchanged.
function EatersRules:Percepts(eater)
    local far, cells, others = self.vision, {}, {};
    for i = #self.eaters, 1, -1 do
        local other = self.eaters[i];
        others[other.y * 1000 + other.x] = other;
    end
    for dy = -far, far do
        cells[dy] = {};
        for dx = -far, far do
            local x, y = eater.x + dx, eater.y + dy;
            cells[dy][dx] = CellOf(self, x, y, others[y * 1000 + x], eater.hasMoved);
        end
    end
    for dy = -far, far do
        local row, above, below = cells[dy], cells[dy - 1], cells[dy + 1];
        for dx = -far, far do
            local cell = row[dx];
            cell.north, cell.south = above and above[dx], below and below[dx];
            cell.east, cell.west = row[dx + 1], row[dx - 1];
        end
    end
    eater.hasMoved = false;
    return {
        eater = { name = eater.color, score = eater.score, x = eater.x, y = eater.y, direction = eater.direction },
        ["my-location"] = cells[0][0],
        random = self.random()
    };
end
