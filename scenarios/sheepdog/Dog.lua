-- SPDX-License-Identifier: BSD-2-Clause
-- The body of the dog. It looks at the flock, and carries out three commands of the mind, two of them over time:
--   gather            runs round the straggler and back, until the flock is together
--   drive ^to PLACE   pushes the flock to the gate or into the pen
--   rest              stands
require "AgentUtilities";
require "Meadow";

local kTogether, kScattered = 4.5, 8;   -- m: from the middle to the farthest sheep: below, above.
local kBehind = 4;                      -- m: its distance behind the sheep that it moves.
local kPress = 3;                       -- m: how much nearer it is when it drives the flock.
local kRound = 3;                       -- m: its distance from the flock when it runs round it.
local kArrived = 5;                     -- m: the flock is at the gate if it is nearer.
local kRun, kWalk = 8, 3.4;

local goal = "rest";                    -- "gather", "gate", "pen" or "rest".
local flock = { left = 0, penned = 0, spread = 0, scattered = false };
local beginning = 1;                    -- How much there was to do when the command was given, in m.

function Agent_Initialize(agent)
    local body = Core.CreateBox(agent, 0.5, 0.8, 1.2);
    Core.SetMaterial(body, "Soarbox/Wolf");
    agent:SetHeight(0.9);
    agent:SetRadius(0.35);
    Core.SetPosition(body, Vector.new(0, -0.05, 0));
    agent:SetMass(25);
    agent:SetMaxForce(700);
    agent:SetMaxSpeed(kRun);
end

-- The sheep that are not in the pen: how many, their middle, and the one farthest from it.
local function LookAtFlock(agent)
    local sum, left = Vector.new(), {};
    flock.penned = 0;
    for _, other in ipairs(Sandbox.GetAgents(agent:GetSandbox())) do
        if (other:GetTeam() == "sheep") then
            local place = other:GetPosition();
            if (Meadow.IsInPen(place)) then
                flock.penned = flock.penned + 1;
            else
                table.insert(left, place);
                sum = sum + place;
            end
        end
    end
    flock.left = #left;
    if (#left == 0) then
        flock.scattered = false;
        return;
    end
    flock.middle = sum / #left;
    flock.spread = 0;
    for _, place in ipairs(left) do
        local off = Vector.Distance(place, flock.middle);
        if (off >= flock.spread) then
            flock.spread, flock.straggler = off, place;
        end
    end
    -- The two limits differ, so that the value does not alternate.
    if (flock.spread > kScattered) then
        flock.scattered = true;
    elseif (flock.spread < kTogether) then
        flock.scattered = false;
    end
end

-- In front of the gate, or already on its way through.
local function IsAtGate()
    return flock.left > 0 and flock.middle.z > Meadow.Gate.z - kArrived and math.abs(flock.middle.x) < 2 * kArrived;
end

-- Runs before the mind decides.
function Agent_Sense(agent)
    LookAtFlock(agent);
    return { flock = {
        left = flock.left, penned = flock.penned, scattered = flock.scattered, ["at-gate"] = IsAtGate()
    } };
end

-- The place from which sheep within `radius` of `from` are pushed towards `to`.
local function Behind(from, to, radius)
    return from + Vector.Normalize(from - to) * (radius + kBehind);
end

-- Where it wants to be now; nil if it has nothing to do.
local function Place()
    if (flock.left == 0) then
        return nil;
    elseif (goal == "gather") then
        return Behind(flock.straggler, flock.middle, 0);
    elseif (goal == "gate") then
        return Behind(flock.middle, Meadow.Gate, flock.spread - kPress);
    elseif (goal == "pen") then
        return Behind(flock.middle, Meadow.Pen, flock.spread - kPress);
    end
end

-- A place on the way to `place` that does not lead through the flock.
local function Around(here, place)
    local to, toMiddle = place - here, flock.middle - here;
    local length = Vector.Length(to);
    if (length < 0.1) then
        return place;
    end
    local along = Vector.DotProduct(to, toMiddle) / length;
    local off = here + to / length * along - flock.middle;
    local radius = flock.spread + kRound;
    if (goal == "gather" or Vector.Length(off) > radius or along < 0 or along > length) then
        return place;
    end
    if (Vector.Length(off) < 0.5) then
        off = Vector.new(toMiddle.z, 0, -toMiddle.x);
    end
    return flock.middle + Vector.Normalize(off) * (radius + 2);
end

-- Runs in each tick, whatever the mind does.
function Agent_Tick(agent, deltaTimeInMillis)
    local here, place = agent:GetPosition(), Place();
    local force, speed = agent:ForceToTargetSpeed(0), kRun;
    if (place) then
        place.y = here.y;
        local to = Around(here, place) - here;
        if (Vector.Length(to) > 0.4) then
            force = Vector.Normalize(to);
        end
        -- Behind the flock it walks, so that the sheep do not run apart.
        if (Vector.Distance(here, place) < 3 and goal ~= "gather") then
            speed = kWalk;
        end
    end
    agent:SetMaxSpeed(speed);
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
    agent:Show("goal", goal);
    agent:Show("flock", { left = flock.left, penned = flock.penned, spread = flock.spread });
end

-- What is left to do of a command, in m.
local function LeftToDo()
    if (goal == "gather") then
        return math.max(0, flock.spread - kTogether);
    end
    return Vector.Distance(flock.middle, goal == "gate" and Meadow.Gate or Meadow.Pen);
end

local function Begin(command, parameters)
    goal = command == "drive" and parameters.to or command;
    parameters.begun = true;
    beginning = flock.left > 0 and math.max(0.1, LeftToDo()) or 1;
end

-- Called for each new command of the mind, and again in each tick while it returns "running". The table of parameters
-- is the same each time.
function Agent_Update(agent, deltaTimeInMillis, command, parameters)
    if (command == "rest") then
        goal = "rest";
        return "complete";
    end
    if (command == "drive" and parameters.to ~= "gate" and parameters.to ~= "pen") then
        return "error", "unknown-place", "^to is gate or pen";
    end
    if (not parameters.begun) then
        Begin(command, parameters);
    end
    if (flock.left == 0) then
        return "complete";
    elseif (command == "gather") then
        if (not flock.scattered) then
            return "complete";
        end
    elseif (flock.scattered) then
        return "error", "scattered", "the flock has run apart";
    elseif (parameters.to == "gate" and IsAtGate()) then
        return "complete";
    end
    return "running", 1 - LeftToDo() / beginning;
end
