-- SPDX-License-Identifier: BSD-2-Clause
-- A pony: it grazes, walks about and looks around. When somebody whistles, it trots there and rears.
-- Each of these is an animation of pony.gltf; Animation.Play blends from one to the next.
local kHeight, kField = 1.5, 16;
-- Speeds in m/s at which the feet of the animations do not slide.
local kWalk, kTrot = 1.1, 3.0;
local kTurn = 100; -- degrees per second

local mesh, goal, rest, heading, speed, wanted = nil, nil, 0, 0, 0, 0;
local doing = "";

local function Do(agent, what, loops, blend)
    if (doing == what) then return; end
    doing = what;
    Animation.Play(mesh, what, loops, 1, blend);
    agent:Show("does", what);
end

local function SomewhereElse()
    return Vector.new(math.random() * 2 * kField - kField, 0, math.random() * 2 * kField - kField);
end

function Agent_Initialize(agent)
    agent:SetHeight(kHeight);
    agent:SetRadius(0.6);
    agent:SetMass(200);
    heading = math.random() * 360;
    agent:SetPosition(SomewhereElse() + Vector.new(0, kHeight / 2, 0));
    mesh = Core.CreateMesh(agent, "pony.gltf");
    -- The origin of the file is on the ground, that of an agent in its middle.
    Core.SetPosition(mesh, Vector.new(0, -kHeight / 2, 0));
    Do(agent, "graze", true, 0);
    rest = 1 + 4 * math.random();
    Sandbox.AddEventCallback(agent:GetSandbox(), agent, function(sandbox, agent, type, event)
        if (type == "Whistle") then
            -- Each stops at a distance, on its own side.
            local away = agent:GetPosition() - event.position;
            away.y = 0;
            goal, wanted = event.position + Vector.Normalize(away) * 3.5, kTrot;
        end
    end);
end

-- At the goal, a pony that was called rears; others look around and then graze.
local function Arrive(agent)
    goal = nil;
    if (wanted == kTrot) then
        Do(agent, "rear", false, 0.3);
        rest = 2.2;
    else
        Do(agent, "idle", true, 0.4);
        rest = 2 + 2 * math.random();
    end
    wanted = 0;
end

local function Rest(agent, seconds)
    rest = rest - seconds;
    if (rest > 0) then return; end
    if (doing == "rear") then
        Do(agent, "idle", true, 0.3);
        rest = 3;
    elseif (doing == "idle") then
        Do(agent, "graze", true, 0.6);
        rest = 4 + 5 * math.random();
    else
        goal, wanted = SomewhereElse(), kWalk;
    end
end

function Agent_Update(agent, milliseconds)
    local seconds = milliseconds / 1000;
    local drive = 0;
    if (goal) then
        local way = goal - agent:GetPosition();
        way.y = 0;
        if (Vector.Length(way) < 0.8) then
            Arrive(agent);
        else
            local off = (math.deg(math.atan2(way.x, way.z)) - heading + 180) % 360 - 180;
            heading = heading + math.max(-kTurn * seconds, math.min(kTurn * seconds, off));
            drive = wanted;
        end
    else
        Rest(agent, seconds);
    end
    speed = speed + math.max(-4 * seconds, math.min(4 * seconds, drive - speed));
    if (goal) then
        local gait = wanted == kTrot and "trot" or "walk";
        Do(agent, gait, true, 0.35);
    end
    local forward = Vector.new(math.sin(math.rad(heading)), 0, math.cos(math.rad(heading)));
    agent:SetForward(forward);
    agent:SetVelocity(forward * speed);
end
