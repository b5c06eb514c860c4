-- SPDX-License-Identifier: BSD-2-Clause
-- Common parts of games on a board of cells: the board in the world, bodies that glide from cell to cell, a camera that
-- shows everything, a table of scores, and the clock of the turns.
GridGame = {};
GridGame.__index = GridGame;

GridGame.Cell = 1.5;       -- Metres.
-- The scenario specifies the number of ticks (`turn = 10`).
GridGame.TicksPerTurn = (Sandbox_TurnTicks or 1) > 1 and Sandbox_TurnTicks or 10;

-- The colours of players, in the order in which they join, and their materials.
GridGame.Colors = { "red", "blue", "yellow", "purple", "orange", "green", "black" };
GridGame.Materials = {
    red = "Red", blue = "Blue", yellow = "Soarbox/Yellow", purple = "Soarbox/Purple", orange = "Soarbox/Orange",
    green = "Green", black = "Soarbox/Black"
};
GridGame.Headings = { north = Vector.new(0, 0, -1), east = Vector.new(1, 0, 0), south = Vector.new(0, 0, 1),
                      west = Vector.new(-1, 0, 0) };

local kWallHeight = 0.6;

-- A board with this number of cells, numbered from 1; north is away from the camera.
function GridGame.new(sandbox, width, height)
    return setmetatable({ sandbox = sandbox, width = width, height = height, tick = 0, bodies = {} }, GridGame);
end

-- The centre of a cell, at this height above the ground.
function GridGame:PlaceOf(x, y, up)
    return Vector.new((x - (self.width + 1) / 2) * GridGame.Cell, up or 0, (y - (self.height + 1) / 2) * GridGame.Cell);
end

-- A thing without effect at a cell, only to be seen.
function GridGame:Put(node, x, y, up, material)
    Core.SetPosition(node, self:PlaceOf(x, y, up));
    Core.SetMaterial(node, material);
    return node;
end

function GridGame:PutBox(x, y, size, material, up)
    return self:Put(Core.CreateBox(self.sandbox, size.x, size.y, size.z), x, y, (up or 0) + size.y / 2, material);
end

function GridGame:PutBall(x, y, radius, material, up)
    return self:Put(Core.CreateCapsule(self.sandbox, 2 * radius, radius), x, y, up or radius, material);
end

-- Light, ground and sky, a floor in two colours, and a wall around it.
function GridGame:BuildBoard(light, dark, wall)
    require "Plain";
    Plain_Create(self.sandbox);
    local side = GridGame.Cell;
    for y = 1, self.height do
        for x = 1, self.width do
            self:PutBox(x, y, Vector.new(side, 0.1, side), (x + y) % 2 == 0 and light or dark);
        end
    end
    local long = Vector.new((self.width + 2) * side, kWallHeight, side);
    local deep = Vector.new(side, kWallHeight, self.height * side);
    self:PutBox((self.width + 1) / 2, 0, long, wall);
    self:PutBox((self.width + 1) / 2, self.height + 1, long, wall);
    self:PutBox(0, (self.height + 1) / 2, deep, wall);
    self:PutBox(self.width + 1, (self.height + 1) / 2, deep, wall);
end

-- A camera position that shows the entire board, to the right of the table of scores.
function GridGame:LookAtBoard()
    local far = math.max(self.width + 3, 1.25 * (self.height + 3)) * GridGame.Cell;
    Sandbox.SetCameraPosition(self.sandbox, Vector.new(-0.16 * far, 0.87 * far, 0.53 * far));
    Sandbox.SetCameraOrientation(self.sandbox, Vector.new(-60, 0, 0));
    Sandbox.SetCameraFixed(self.sandbox, true);
end

-- Scores --------------------------------------------------------------------------------------------------------------

-- The colours of players for text on a dark panel, in the order of GridGame.Colors.
local kTextColors = { { 1, 0.5, 0.45 }, { 0.5, 0.72, 1 }, { 1, 0.9, 0.35 }, { 0.82, 0.6, 1 }, { 1, 0.68, 0.3 },
                      { 0.5, 0.92, 0.5 }, { 0.75, 0.75, 0.75 } };

local function Panel(sandbox)
    Sandbox.SetMarkupColor(sandbox, 0, 1, 1, 1);
    for i, color in ipairs(kTextColors) do
        Sandbox.SetMarkupColor(sandbox, i, color[1], color[2], color[3]);
    end
    local panel = Sandbox.CreateUIComponent(sandbox, 2);
    UI.SetBackgroundColor(panel, 0.07, 0.09, 0.12, 0.72);
    UI.SetTextMargin(panel, 8, 12);
    return panel;
end

-- The beginning of a row: a player's colour, in that colour.
function GridGame.NameRow(color)
    for i, name in ipairs(GridGame.Colors) do
        if (name == color) then
            return "%" .. i .. string.format("%-9s", color) .. "%0 ";
        end
    end
end

-- Shows lines of text in the corner; they may use the markup of NameRow.
function GridGame:ShowTable(lines)
    self.panel = self.panel or Panel(self.sandbox);
    local widest = 0;
    for _, line in ipairs(lines) do
        widest = math.max(widest, #line:gsub("%%%d", ""));
    end
    UI.SetPosition(self.panel, 16, 56);
    UI.SetDimensions(self.panel, 26 + 11 * widest, 20 + 22 * #lines);
    UI.SetMarkupText(self.panel, "%@141%" .. table.concat(lines, "\n"));
end

-- Bodies --------------------------------------------------------------------------------------------------------------

-- Uses an agent as the body of a player {x, y, direction}.
function GridGame:AddBody(agent, player, up)
    local body = { agent = agent, player = player, up = up or agent:GetHeight() / 2 };
    body.from = self:PlaceOf(player.x, player.y, body.up);
    body.to = body.from;
    agent:SetPosition(body.from);
    agent:SetForward(GridGame.Headings[player.direction]);
    self.bodies[#self.bodies + 1] = body;
    return body;
end

-- Bodies move to the current cells of the players during the turn. Players listed in `jumps` leap.
local function BeginGlide(self, body)
    body.from = body.to;
    body.to = self:PlaceOf(body.player.x, body.player.y, body.up);
    local away = Vector.Distance(body.from, body.to) / GridGame.Cell;
    body.leaps = away > 1.5 and away < 2.5;
    if (away >= 2.5) then
        body.from = body.to;  -- It was placed elsewhere, and does not glide.
    end
    body.turnsFrom = body.agent:GetForward();
    body.turnsTo = GridGame.Headings[body.player.direction];
end

local function Glide(body, share)
    local place = body.from + (body.to - body.from) * share;
    if (body.leaps) then
        place.y = place.y + 1.6 * math.sin(math.pi * share);
    end
    body.agent:SetPosition(place);
    -- There is no direction half-way through a half turn: use that of the end of the turn.
    local facing = body.turnsFrom + (body.turnsTo - body.turnsFrom) * math.min(1, 3 * share);
    if (Vector.LengthSquared(facing) > 0.01) then
        body.agent:SetForward(facing);
    end
end

-- The clock -----------------------------------------------------------------------------------------------------------

-- Whether minds perceive and decide in this tick.
function GridGame:IsDecisionTick()
    return self.tick % GridGame.TicksPerTurn == 0;
end

-- Call it once per tick. `play` is called at the beginning of each turn, when all commands are known. Returns the
-- fraction of the turn that has passed.
function GridGame:Advance(play)
    if (self:IsDecisionTick()) then
        play();
        for _, body in ipairs(self.bodies) do
            BeginGlide(self, body);
        end
    end
    self.tick = self.tick + 1;
    local share = ((self.tick - 1) % GridGame.TicksPerTurn + 1) / GridGame.TicksPerTurn;
    for _, body in ipairs(self.bodies) do
        Glide(body, share);
    end
    return share;
end
