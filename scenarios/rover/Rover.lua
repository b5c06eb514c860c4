-- SPDX-License-Identifier: BSD-2-Clause
-- The rover: a model from a file, driven by arrow keys, by a gamepad, or by itself.
local kFastest, kTurn = 7, 110; -- m/s; degrees per second
local throttle, wheel, heading, speed = 0, 0, 0, 0;
local pressed = {};
local goal, runs = nil, false;

function Agent_Initialize(agent)
    agent:SetHeight(1);
    agent:SetRadius(0.9);
    agent:SetMass(80);
    agent:SetPosition(Vector.new(0, 0.5, 0));
    local body = Core.CreateMesh(agent, "rover.glb");
    -- The origin of the file is on the ground, that of an agent in its middle.
    Core.SetPosition(body, Vector.new(0, -0.5, 0));
    Sandbox.AddEventCallback(agent:GetSandbox(), agent, function(sandbox, agent, type, event)
        if (type == "Goal") then goal = event.position; end
        if (type == "Manual") then goal = nil; end
        if (type == "Run") then runs = event.runs == 1; end
    end);
end

function Agent_HandleEvent(agent, event)
    if (event.source == "keyboard") then
        pressed[event.key] = event.pressed and 1 or 0;
        throttle = (pressed["up_key"] or 0) - (pressed["down_key"] or 0);
        wheel = (pressed["left_key"] or 0) - (pressed["right_key"] or 0);
    elseif (event.source == "gamepad" and event.axis == "left_x") then
        wheel = -event.value;
    elseif (event.source == "gamepad" and event.axis == "left_y") then
        throttle = -event.value;
    end
end

-- How to drive towards the goal.
local function Autopilot(agent)
    local way = goal - agent:GetPosition();
    local off = math.deg(math.atan2(way.x, way.z)) - heading;
    off = (off + 180) % 360 - 180;
    local turn = math.max(-1, math.min(1, off / 25));
    return math.abs(off) > 60 and 0.3 or 1, turn;
end

function Agent_Update(agent, milliseconds)
    local seconds = milliseconds / 1000;
    local drive, turn = throttle, wheel;
    if (goal and drive == 0 and turn == 0) then drive, turn = Autopilot(agent); end
    if (not runs) then drive, turn = 0, 0; end
    speed = speed + (drive * kFastest - speed) * math.min(1, 2.5 * seconds);
    heading = heading + turn * kTurn * seconds * math.min(1, math.abs(speed) / 2) * (speed < 0 and -1 or 1);
    local forward = Vector.new(math.sin(math.rad(heading)), 0, math.cos(math.rad(heading)));
    agent:SetForward(forward);
    agent:SetVelocity(forward * speed);
    agent:Show("drives", goal and "by itself" or "by hand");
    agent:Show("speed", math.floor(speed * 10 + 0.5) / 10);
end
