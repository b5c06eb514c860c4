-- SPDX-License-Identifier: BSD-2-Clause
-- A sheep: three wishes compete, and the strongest one wins (utility). It flees from a dog that is near, keeps with the
-- flock, or grazes. In the pen it is calm.
require "AgentUtilities";
require "Meadow";

local kFlight = 10;       -- m: a dog that is nearer is dangerous.
local kRoom = 1.6;        -- m: other sheep that are nearer are too near.
local kFlock = 14;        -- m: farther sheep do not count.
local kRun, kWalk, kGraze = 4.2, 2.2, 0.5;

local dog;
local others = {};

local function FindOthers(agent)
    for _, other in ipairs(Sandbox.GetAgents(agent:GetSandbox())) do
        if (other:GetTeam() == "sheep") then
            table.insert(others, other);
        elseif (other:GetTeam() == "dog") then
            dog = other;
        end
    end
end

function Agent_Initialize(agent)
    local body = Core.CreateBox(agent, 0.7, 0.9, 1.2);
    Core.SetMaterial(body, "Soarbox/Sheep");
    agent:SetHeight(1);
    agent:SetRadius(0.4);
    Core.SetPosition(body, Vector.new(0, -0.05, 0));
    agent:SetMass(40);
    agent:SetMaxForce(400);
    agent:SetMaxSpeed(kRun);
end

local function Level(vector)
    vector.y = 0;
    return vector;
end

-- Back to the meadow from its edge.
local function Inwards(place)
    local force = Vector.new();
    local edge = Meadow.HalfWidth;
    if (place.x > edge) then force.x = -1; elseif (place.x < -edge) then force.x = 1; end
    if (place.z > edge) then force.z = -1; elseif (place.z < -edge) then force.z = 1; end
    return force * 2;
end

-- How strong each wish is, 0 to 1.
local function Wishes(agent, isPenned)
    local place = agent:GetPosition();
    local danger = dog and 1 - Vector.Distance(place, dog:GetPosition()) / kFlight or 0;
    if (isPenned) then
        danger = danger - 0.8;
    end
    local lonely = 0;
    local centre = agent:ForceToCombine(kFlock, 180, others);
    if (Vector.Length(centre) > 0 and not isPenned) then
        lonely = 0.25;
    end
    return { flee = math.max(0, danger), flock = lonely, graze = 0.2 };
end

local function Strongest(wishes)
    local best = "graze";
    for _, name in ipairs({ "flock", "flee" }) do
        if (wishes[name] > wishes[best]) then
            best = name;
        end
    end
    return best;
end

-- The force and the maximum speed for each wish.
local deeds = {};

function deeds.flee(agent)
    local away = Vector.Normalize(Level(agent:ForceToFleePosition(dog:GetPosition())));
    return away + agent:ForceToCombine(kFlock, 180, others) * 0.7 + agent:ForceToAlign(kFlock, 180, others) * 0.2, kRun;
end

function deeds.flock(agent)
    return agent:ForceToCombine(kFlock, 180, others), kGraze;
end

function deeds.graze(agent)
    return agent:ForceToWander(1), kGraze;
end

function Agent_Update(agent, deltaTimeInMillis)
    if (not dog) then
        others = {};
        FindOthers(agent);
    end
    local isPenned = Meadow.IsInPen(agent:GetPosition());
    local wishes = Wishes(agent, isPenned);
    local wish = Strongest(wishes);
    local force, speed = deeds[wish](agent);
    force = force + agent:ForceToSeparate(kRoom, 180, others) * 0.8 + Inwards(agent:GetPosition());
    agent:SetMaxSpeed(speed);
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
    agent:Show("wish", wish);
    agent:Show("wishes", {
        { name = "flee", value = wishes.flee, active = wish == "flee" },
        { name = "flock", value = wishes.flock, active = wish == "flock" },
        { name = "graze", value = wishes.graze, active = wish == "graze" }
    });
end
