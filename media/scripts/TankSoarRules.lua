-- SPDX-License-Identifier: BSD-2-Clause
-- The rules of TankSoar, without bodies, pictures and minds. Tanks on a board of cells fire missiles at each other.
-- docs/tanksoar.md describes the game; tests/lua/TankSoarRulesTest.lua states each rule. Used like EatersRules.lua:
-- new, Join, and in each turn Percepts, Command and Turn.
require "GridBoard";
require "TankSoarMaps";

TankSoarRules = {};
TankSoarRules.__index = TankSoarRules;

-- Quarters to the right.
local kTurns = { forward = 0, right = 1, backward = 2, left = 3 };
local kSides = { "forward", "right", "backward", "left" };
local kSigns = { ["#"] = "obstacle", [" "] = "open", ["H"] = "health", ["E"] = "energy", ["M"] = "missiles" };
TankSoarRules.Defaults = {
    map = "clumps",                                      -- Lines, "random", or a name (TankSoarMaps.lua).
    facing = {},                                         -- First direction of each tank; random if missing.
    mostHealth = 1000, mostEnergy = 1000, missiles = 15,
    mostPacks = 3, packChance = 5, packMissiles = 7,     -- Percent in each turn.
    collisionDamage = 100, missileDamage = 400,
    shieldEnergy = 20, shieldHitEnergy = 250,
    chargeHealth = 150, chargeEnergy = 250,
    hitAward = 2, hitPenalty = 1, destroyAward = 3, destroyPenalty = 2,
    mostRadar = 14, soundReach = 7, quietTurns = 100, winningScore = 50
};

local function Relative(tank, side)
    return GridBoard.Turned(tank.direction, kTurns[side]);
end

-- The board -----------------------------------------------------------------------------------------------------------

-- The kind of a cell, without tanks: "obstacle", "open", "health", "energy" or "missiles". Cells outside of the board
-- are obstacles.
function TankSoarRules:ContentAt(x, y)
    local row = self.cells[y];
    return row and row[x] or "obstacle";
end

local function IsObstacle(game, x, y)
    return game:ContentAt(x, y) == "obstacle";
end

local function IsCharger(game, tank)
    local content = game:ContentAt(tank.x, tank.y);
    return content == "health" or content == "energy";
end

-- A random empty cell.
local function FreeCell(game)
    local free = {};
    for y = 1, game.height do
        for x = 1, game.width do
            if (game:ContentAt(x, y) == "open" and not GridBoard.At(game.tanks, x, y)) then
                free[#free + 1] = { x = x, y = y };
            end
        end
    end
    if (#free == 0) then
        error("the board has no free cell");
    end
    return free[game.random(#free)];
end

local function Place(game, content)
    local cell = FreeCell(game);
    game.cells[cell.y][cell.x] = content;
end

local function Count(game, content)
    local count = 0;
    for y = 1, game.height do
        for x = 1, game.width do
            count = count + (game.cells[y][x] == content and 1 or 0);
        end
    end
    return count;
end

-- A game with these settings; the others are those of TankSoarRules.Defaults. `random` is like math.random.
function TankSoarRules.new(settings)
    local game = setmetatable({ cells = {}, starts = {}, tanks = {}, flying = {}, explosions = {}, turn = 0,
                                quiet = 0, made = 0 }, TankSoarRules);
    GridBoard.Settle(game, TankSoarRules.Defaults, settings);
    game.map = TankSoarMaps.Lines(game.map, game.random);
    GridBoard.Read(game, game.map, kSigns, "open", "# H E M");
    for _, charger in ipairs({ "energy", "health" }) do
        if (Count(game, charger) == 0) then
            Place(game, charger);
        end
    end
    while (Count(game, "missiles") < game.mostPacks) do
        Place(game, "missiles");
    end
    return game;
end

-- Tanks ---------------------------------------------------------------------------------------------------------------

local function Fill(game, tank)
    tank.health, tank.energy, tank.missiles = game.mostHealth, game.mostEnergy, game.missiles;
    tank.hasComeBack = true;
    tank.view = tank.view + 1;
end

function TankSoarRules:Join(color)
    local start = self.starts[#self.tanks + 1] or FreeCell(self);
    local tank = {
        color = color, x = start.x, y = start.y, score = 0,
        direction = self.facing[#self.tanks + 1] or GridBoard.Directions[self.random(4)],
        shields = false, radar = false, radarPower = 0,
        view = 0, -- Grows when the tank moves, turns or comes back.
        wish = {}
    };
    Fill(self, tank);
    self.tanks[#self.tanks + 1] = tank;
    return tank;
end

local kWays, kSwitch = { "forward", "backward", "left", "right", "none" }, { "on", "off" };
TankSoarRules.Commands = {
    move = { direction = kWays }, rotate = { direction = { "left", "right" } }, fire = {},
    radar = { switch = kSwitch }, shields = { switch = kSwitch }, ["radar-power"] = { setting = "number" }
};
local kTurnedInstead = "a tank that rotates does not move in that turn";

-- Accepts a command for this turn. Returns nil if a tank can execute it, else the reason; and a remark, both as results
-- of Sandbox_Command.
function TankSoarRules:Command(tank, said, parameters)
    local name, value, details = GridBoard.Understand(TankSoarRules.Commands, said, parameters);
    local wish = tank.wish;
    if (not name) then
        return value, details;
    elseif (wish[name] ~= nil) then
        return "once-a-turn", { text = "it has given ^" .. name .. " in this turn" };
    elseif (name == "move" and wish.rotate) then
        return "move-or-rotate", { text = kTurnedInstead };
    elseif (name == "radar-power" and (value < 0 or value > self.mostRadar)) then
        wish[name] = math.max(0, math.min(self.mostRadar, value));
        return nil, { text = "a radar's power is 0 to " .. self.mostRadar .. ": it is set to " .. wish[name] };
    elseif (name == "fire" and tank.missiles == 0) then
        wish.fire = true;
        return nil, { text = "it has no missiles" };
    end
    wish[name] = value or true;
    if (name == "radar" or name == "shields") then
        wish[name] = value == "on";
    elseif (name == "rotate" and wish.move) then
        return nil, { drops = "move", reason = "move-or-rotate", text = kTurnedInstead };
    end
end

-- Damage --------------------------------------------------------------------------------------------------------------

local function Adjust(tank, what, by, most)
    tank[what] = math.max(0, math.min(most, tank[what] + by));
end

-- Notes which tank has destroyed which.
local function NoteEnd(game, tank, by)
    if (tank.health > 0) then
        return;
    end
    game.destroyed[tank] = game.destroyed[tank] or {};
    if (by and by ~= tank) then
        game.destroyed[tank][by] = true;
    end
end

local function Damage(game, tank, by, other)
    Adjust(tank, "health", -by, game.mostHealth);
    NoteEnd(game, tank, other);
end

local function Ram(game, tank, by, other)
    Damage(game, tank, IsCharger(game, tank) and tank.health or by, other);
end

local function Explode(game, x, y)
    game.explosions[#game.explosions + 1] = { x = x, y = y };
end

local function Hit(game, tank, missile)
    if (tank.shields) then
        Adjust(tank, "energy", -game.shieldHitEnergy, game.mostEnergy);
    else
        Adjust(tank, "health", -game.missileDamage, game.mostHealth);
    end
    tank.score = tank.score - game.hitPenalty;
    missile.owner.score = missile.owner.score + game.hitAward;
    if (IsCharger(game, tank)) then
        tank.health = 0;
    end
    NoteEnd(game, tank, missile.owner);
    Explode(game, tank.x, tank.y);
end

-- Moving --------------------------------------------------------------------------------------------------------------

-- The target cell of each tank. A tank cannot enter an obstacle, and two tanks that drive towards each other stay in
-- place.
local function FindAims(game)
    local aims = {};
    for _, tank in ipairs(game.tanks) do
        local side = tank.wish.move;
        aims[tank] = { x = tank.x, y = tank.y };
        tank.course = nil;
        if (side and side ~= "none") then
            tank.course = Relative(tank, side);
            local step = GridBoard.Steps[tank.course];
            local x, y = tank.x + step.x, tank.y + step.y;
            if (IsObstacle(game, x, y)) then
                tank.course = nil;
                Damage(game, tank, game.collisionDamage);
            else
                aims[tank] = { x = x, y = y };
            end
        end
    end
    for _, tank in ipairs(game.tanks) do
        local other = tank.course and GridBoard.At(game.tanks, aims[tank].x, aims[tank].y);
        if (other and other.course == GridBoard.Turned(tank.course, 2)) then
            for _, one in ipairs({ tank, other }) do
                one.course = nil;
                aims[one] = { x = one.x, y = one.y };
                Ram(game, one, game.collisionDamage, one == tank and other or tank);
            end
        end
    end
    return aims;
end

-- Tanks with the same target cell stay in their cells, which may be the targets of others. All tanks that had a cell as
-- target count for its damage.
local function SettleMoves(game, aims)
    local claims = {};
    local function Claim(tank)
        local name = aims[tank].x .. "," .. aims[tank].y;
        local claim = claims[name] or {};
        claims[name] = claim;
        claim[#claim + 1] = tank;
        return claim;
    end
    local waiting = {};
    for _, tank in ipairs(game.tanks) do
        waiting[#waiting + 1] = tank;
    end
    while (#waiting > 0) do
        local claim = Claim(table.remove(waiting, 1));
        for _, tank in ipairs(#claim > 1 and claim or {}) do
            if (tank.course) then
                tank.course = nil;
                aims[tank] = { x = tank.x, y = tank.y };
                waiting[#waiting + 1] = tank;
            end
        end
    end
    return claims;
end

local function Charge(game, tank, aim)
    local content = game:ContentAt(aim.x, aim.y);
    tank.onHealth, tank.onEnergy = content == "health", content == "energy";
    if (tank.onHealth) then
        Adjust(tank, "health", game.chargeHealth, game.mostHealth);
    elseif (tank.onEnergy) then
        Adjust(tank, "energy", game.chargeEnergy, game.mostEnergy);
    end
end

local function PayForShields(game, tank)
    if (tank.shields and tank.energy <= 0) then
        tank.shields = false;
    elseif (tank.shields) then
        Adjust(tank, "energy", -game.shieldEnergy, game.mostEnergy);
    end
end

local function PayForRadar(game, tank)
    if (tank.radar and tank.energy <= 0) then
        tank.radar = false;
    elseif (tank.radar) then
        tank.radarPower = math.min(tank.radarPower, tank.energy);
        Adjust(tank, "energy", -tank.radarPower, game.mostEnergy);
    end
end

local function PayForCollisions(game, claims)
    for _, tank in ipairs(game.tanks) do
        for _, claim in pairs(claims) do
            local isIn = false;
            for _, other in ipairs(claim) do
                isIn = isIn or other == tank;
            end
            if (isIn and #claim > 1) then
                for _, other in ipairs(claim) do
                    if (other ~= tank) then
                        Ram(game, tank, game.collisionDamage, other);
                    end
                end
            end
        end
    end
end

-- A tank that enters a cell takes the pack there, and collides with missiles that fly towards it.
local function Drive(game, tank, aim)
    tank.hasMoved = tank.x ~= aim.x or tank.y ~= aim.y;
    tank.x, tank.y = aim.x, aim.y;
    if (not tank.hasMoved) then
        return;
    end
    if (game:ContentAt(tank.x, tank.y) == "missiles") then
        game.cells[tank.y][tank.x] = "open";
        tank.missiles = tank.missiles + game.packMissiles;
    end
    for i = #game.flying, 1, -1 do
        local missile = game.flying[i];
        if (missile.x == tank.x and missile.y == tank.y and missile.direction == GridBoard.Turned(tank.course, 2)) then
            table.remove(game.flying, i);
            Hit(game, tank, missile);
        end
    end
end

-- Missiles ------------------------------------------------------------------------------------------------------------

-- One cell further; false if it no longer exists.
local function FlyOn(game, missile)
    local step = GridBoard.Steps[missile.direction];
    missile.x, missile.y = missile.x + step.x, missile.y + step.y;
    local tank = GridBoard.At(game.tanks, missile.x, missile.y);
    if (IsObstacle(game, missile.x, missile.y)) then
        Explode(game, missile.x, missile.y);
    elseif (tank) then
        Hit(game, tank, missile);
    else
        return true;
    end
    return false;
end

-- One cell per turn, and one more in the second of three turns.
local function Fly(game)
    local left = {};
    for _, missile in ipairs(game.flying) do
        missile.age = missile.age + 1;
        local flies = FlyOn(game, missile);
        if (flies and missile.age % 3 == 2) then
            flies = FlyOn(game, missile);
        end
        left[#left + 1] = flies and missile or nil;
    end
    game.flying = left;
end

local function Fire(game, tank)
    game.made = game.made + 1;
    local missile = { owner = tank, x = tank.x, y = tank.y, direction = tank.direction, age = 0, number = game.made };
    if (FlyOn(game, missile)) then
        game.flying[#game.flying + 1] = missile;
    end
end

-- A turn --------------------------------------------------------------------------------------------------------------

local function Obey(game, tank)
    local wish = tank.wish;
    tank.fires = wish.fire and tank.missiles > 0;
    if (tank.fires) then
        tank.missiles = tank.missiles - 1;
    end
    tank.hasRotated = wish.rotate ~= nil;
    if (wish.rotate) then
        tank.direction = Relative(tank, wish.rotate);
        wish.move = nil;
    end
    if (wish.shields ~= nil) then
        tank.shields = wish.shields;
    end
    if (wish.radar ~= nil) then
        tank.radar = wish.radar;
    end
    if (wish["radar-power"]) then
        tank.radarPower = wish["radar-power"];
    end
    tank.hasTried = wish.move ~= nil and wish.move ~= "none";
end

local function BeginAgain(game, tank)
    Explode(game, tank.x, tank.y);
    local cell = FreeCell(game);
    tank.x, tank.y, tank.direction = cell.x, cell.y, GridBoard.Directions[game.random(4)];
    tank.wasThrown = true;
    tank.onHealth, tank.onEnergy = false, false;
    Fill(game, tank);
end

local function SettleEnds(game)
    for _, tank in ipairs(game.tanks) do
        local by = game.destroyed[tank];
        if (by) then
            tank.score = tank.score - game.destroyPenalty;
            for _, other in ipairs(game.tanks) do
                other.score = other.score + (by[other] and game.destroyAward or 0);
            end
            BeginAgain(game, tank);
        end
    end
end

-- Prevents tanks from avoiding each other forever.
local function EndQuiet(game)
    local hasFired = false;
    for _, tank in ipairs(game.tanks) do
        hasFired = hasFired or tank.fires;
    end
    game.quiet = hasFired and 0 or game.quiet + 1;
    if (#game.tanks > 1 and game.quiet >= game.quietTurns and next(game.destroyed) == nil) then
        game.quiet = 0;
        for _, tank in ipairs(game.tanks) do
            BeginAgain(game, tank);
        end
    end
end

function TankSoarRules:Turn()
    self.turn = self.turn + 1;
    self.explosions, self.destroyed = {}, {};
    for _, tank in ipairs(self.tanks) do
        tank.hasComeBack, tank.wasThrown = false, false;
        Obey(self, tank);
    end
    local aims = FindAims(self);
    local claims = SettleMoves(self, aims);
    for _, tank in ipairs(self.tanks) do
        Charge(self, tank, aims[tank]);
        PayForShields(self, tank);
        PayForRadar(self, tank);
    end
    PayForCollisions(self, claims);
    for _, tank in ipairs(self.tanks) do
        Drive(self, tank, aims[tank]);
    end
    Fly(self);
    for _, tank in ipairs(self.tanks) do
        if (tank.fires) then
            Fire(self, tank);
        end
    end
    if (Count(self, "missiles") < self.mostPacks and self.random(100) <= self.packChance) then
        Place(self, "missiles");
    end
    SettleEnds(self);
    EndQuiet(self);
    for _, tank in ipairs(self.tanks) do
        tank.view = tank.view + ((tank.hasMoved or tank.hasRotated) and 1 or 0);
        tank.wish = {};
        self.isOver = self.isOver or tank.score >= self.winningScore;
    end
    self:LookAround();
end

-- Senses --------------------------------------------------------------------------------------------------------------

local function YesOrNo(truth)
    return truth and "yes" or "no";
end

local function ToSides(tank, isTrue, isNew)
    local sides = { _new = isNew };
    for _, side in ipairs(kSides) do
        sides[side] = YesOrNo(isTrue(Relative(tank, side)));
    end
    return sides;
end

-- The radar's view of a cell.
local function Echo(game, tank, x, y, distance, position, from)
    local other = game.places[y * 1000 + x];
    if (other) then
        other.seenFrom[from] = true;
    end
    tank.echoes[#tank.echoes + 1] = {
        kind = other and "tank" or game:ContentAt(x, y), color = other and other.color, x = x, y = y,
        distance = distance, position = position
    };
    return other ~= nil or IsObstacle(game, x, y);
end

local function LookByRadar(game, tank)
    tank.echoes, tank.radarDistance = {}, 0;
    if (not tank.radar or tank.radarPower == 0) then
        return;
    end
    local ahead = GridBoard.Steps[tank.direction];
    local back = GridBoard.Turned(tank.direction, 2);
    local left, right = GridBoard.Turned(tank.direction, 3), GridBoard.Turned(tank.direction, 1);
    local x, y, distance, isBlocked = tank.x, tank.y, 0, false;
    while (distance < tank.radarPower and not isBlocked) do
        local toLeft, toRight = GridBoard.Steps[left], GridBoard.Steps[right];
        -- A tank next to this one is seen from its side.
        Echo(game, tank, x + toLeft.x, y + toLeft.y, distance, "left", distance == 0 and right or back);
        Echo(game, tank, x + toRight.x, y + toRight.y, distance, "right", distance == 0 and left or back);
        x, y, distance = x + ahead.x, y + ahead.y, distance + 1;
        isBlocked = Echo(game, tank, x, y, distance, "center", back);
    end
    tank.radarDistance = distance;
end

-- The first tank towards which each missile flies, with nothing in between; not for a tank's own missiles.
local function FindIncoming(game)
    for _, missile in ipairs(game.flying) do
        local step = GridBoard.Steps[missile.direction];
        local x, y = missile.x + step.x, missile.y + step.y;
        while (not IsObstacle(game, x, y)) do
            local tank = game.places[y * 1000 + x];
            if (tank and tank == missile.owner) then
                break;
            elseif (tank) then
                tank.threatenedFrom[GridBoard.Turned(missile.direction, 2)] = true;
                break;
            end
            x, y = x + step.x, y + step.y;
        end
    end
end

local function Smell(game, tank)
    local nearest, count = nil, 0;
    for _, other in ipairs(game.tanks) do
        local distance = math.abs(other.x - tank.x) + math.abs(other.y - tank.y);
        if (other ~= tank and (not nearest or distance <= nearest.distance)) then
            count = nearest and distance == nearest.distance and count + 1 or 1;
            if (count == 1 or game.random(count) == 1) then
                nearest = { distance = distance, color = other.color };
            end
        end
    end
    return nearest;
end

-- The direction of the first step on a shortest path to the nearest tank that moved or turned; nil if none is near. If
-- several are equally near, one is chosen at random: the random number determines the direction in which the search
-- begins. It is kept as long as there is a sound, so that the direction does not alternate.
local function Listen(game, tank)
    if (#game.tanks < 2) then
        return nil;
    end
    tank.ear = tank.ear or game.random(4) - 1;
    local seen, edge = { [tank.y * 1000 + tank.x] = true }, { { x = tank.x, y = tank.y } };
    for _ = 1, game.soundReach do
        local beyond = {};
        for _, cell in ipairs(edge) do
            for i = 0, 3 do
                local direction = GridBoard.Directions[(i + tank.ear) % 4 + 1];
                local step = GridBoard.Steps[direction];
                local beside = { x = cell.x + step.x, y = cell.y + step.y, first = cell.first or direction };
                local name = beside.y * 1000 + beside.x;
                if (not seen[name] and not IsObstacle(game, beside.x, beside.y)) then
                    seen[name] = true;
                    local other = game.places[name];
                    if (other and (other.hasMoved or other.hasRotated)) then
                        return beside.first;
                    end
                    beyond[#beyond + 1] = beside;
                end
            end
        end
        edge = beyond;
    end
    tank.ear = nil;
end

-- Computes what all tanks sense; called at the end of each turn, and once before the first.
function TankSoarRules:LookAround()
    self.places = {};
    for _, tank in ipairs(self.tanks) do
        tank.seenFrom, tank.threatenedFrom = {}, {};
        self.places[tank.y * 1000 + tank.x] = tank;
    end
    for _, tank in ipairs(self.tanks) do
        LookByRadar(self, tank);
    end
    FindIncoming(self);
    for _, tank in ipairs(self.tanks) do
        tank.smell, tank.sound = Smell(self, tank), Listen(self, tank);
    end
end

local function RadarPercepts(tank)
    if (not tank.radar) then
        return nil;
    end
    local radar = {};
    for _, echo in ipairs(tank.echoes) do
        local seen = {
            distance = echo.distance, position = echo.position, color = echo.color,
            _key = tank.view .. ":" .. echo.position .. ":" .. echo.distance
        };
        radar[echo.kind] = radar[echo.kind] or {};
        table.insert(radar[echo.kind], seen);
    end
    return radar;
end

local function SoundOf(tank)
    for _, side in ipairs(kSides) do
        if (tank.sound and Relative(tank, side) == tank.sound) then
            return side;
        end
    end
    return "silent";
end

-- The percepts of a tank.
function TankSoarRules:Percepts(tank)
    if (not tank.echoes) then
        self:LookAround();
    end
    local scores = {};
    for _, other in ipairs(self.tanks) do
        scores[other.color] = other.score;
    end
    local function IsBlocked(direction)
        local step = GridBoard.Steps[direction];
        local x, y = tank.x + step.x, tank.y + step.y;
        return IsObstacle(self, x, y) or GridBoard.At(self.tanks, x, y) ~= nil;
    end
    return {
        x = tank.x, y = tank.y, direction = tank.direction,
        health = tank.health, energy = tank.energy, missiles = tank.missiles,
        healthrecharger = YesOrNo(tank.onHealth), energyrecharger = YesOrNo(tank.onEnergy),
        ["shield-status"] = tank.shields and "on" or "off", ["radar-status"] = tank.radar and "on" or "off",
        ["radar-setting"] = tank.radarPower, ["radar-distance"] = tank.radarDistance,
        radar = RadarPercepts(tank),
        blocked = ToSides(tank, IsBlocked, tank.hasTried or tank.hasRotated),
        incoming = ToSides(tank, function(direction) return tank.threatenedFrom[direction]; end),
        rwaves = ToSides(tank, function(direction) return tank.seenFrom[direction]; end),
        smell = tank.smell and { color = tank.smell.color, distance = tank.smell.distance }
            or { color = "none", distance = "none" },
        sound = SoundOf(tank),
        ["current-score"] = scores, ["my-color"] = tank.color,
        clock = self.turn + 1, random = self.random(), resurrect = YesOrNo(tank.hasComeBack),
        resurrected = YesOrNo(tank.hasComeBack)
    };
end
