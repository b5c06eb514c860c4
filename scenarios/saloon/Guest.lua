-- SPDX-License-Identifier: BSD-2-Clause
-- A guest: walks through the doors to a place at the bar, stays for a drink, and leaves by the back door.
require "AgentUtilities";

local kNear = 1;             -- m: there.
local kDoors = Vector.new(0, 0, -1.5);

local way, step;
local drinkUntil;

function Agent_Initialize(agent)
    agent:SetHeight(1.7);
    agent:SetRadius(0.3);
    agent:SetMass(70);
    agent:SetMaxForce(600);
    agent:SetMaxSpeed(1.8 + math.random() * 0.8);
    local body = Core.CreateBox(agent, 0.6, 1.7, 0.5);
    Core.SetMaterial(body, "Soarbox/Villager");
    way = {
        kDoors,
        Vector.new(0, 0, 2),
        Vector.new(-6.5 + math.random() * 7, 0, 8.6),
        Vector.new(9, 0, 10),
        Vector.new(20, 0, 10)
    };
    step = 1;
end

local function Drink(sandbox)
    local now = Sandbox.GetTimeInSeconds(sandbox);
    drinkUntil = drinkUntil or now + 2 + math.random() * 3;
    return now < drinkUntil;
end

function Agent_Update(agent, deltaTimeInMillis)
    local isAtBar = step == 4;
    local goal = way[step];
    local offset = goal - agent:GetPosition();
    offset.y = 0;
    if (isAtBar and Drink(agent:GetSandbox())) then
        agent:Show("state", "drinks");
        agent:SetVelocity(Vector.new(0, agent:GetVelocity().y, 0));
        return;
    end
    if (Vector.Length(offset) < kNear and step < #way) then
        step = step + 1;
    end
    agent:Show("state", step <= 3 and "comes in" or "leaves");
    local force = Vector.Normalize(offset) + agent:ForceToSeparate(1, 180) * 0.5;
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
end
