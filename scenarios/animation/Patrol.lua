-- SPDX-License-Identifier: BSD-2-Clause
-- Goes round the parade: the first patrol walks, the second runs; now and then it shoots on the way.
require "SoldierBody";

local kRoute = { Vector.new(11, 0, -3), Vector.new(11, 0, 12), Vector.new(-11, 0, 12), Vector.new(-11, 0, -3) };
local kLookAhead, kTurn = 1.5, 0.15;

local soldier, shot;
local untilShot = 3000;

function Agent_Initialize(agent)
    local runs = #Sandbox.GetAgents(agent:GetSandbox()) % 2 == 0;
    agent:SetTeam(runs and "team2" or "team1");
    agent:SetMaxSpeed(runs and 3.6 or 1.4);
    agent:SetPosition(Vector.new(runs and -1.5 or 2, 0.8, -3));
    agent:SetPath(kRoute, true);
    soldier = SoldierBody_Create(agent, runs and "ready" or "aim", runs);
end

local function Walk(agent)
    local position = agent:GetPosition();
    local ahead = agent:GetPointOnPath(agent:GetDistanceAlongPath(position) + kLookAhead) - position;
    ahead.y = 0;
    local forward = agent:GetForward();
    agent:SetForward(forward + (Vector.Normalize(ahead) - forward) * kTurn);
    local velocity = agent:GetForward() * agent:GetMaxSpeed();
    velocity.y = agent:GetVelocity().y;
    agent:SetVelocity(velocity);
end

function Agent_Update(agent, deltaTimeInMillis)
    Walk(agent);
    untilShot = untilShot - deltaTimeInMillis;
    if (shot and not SoldierBody_Step(shot, deltaTimeInMillis)) then
        shot = nil;
    elseif (not shot and untilShot <= 0) then
        untilShot = 3000;
        shot = SoldierBody_Play(soldier, "stand_fire_one_shot");
    end
end
