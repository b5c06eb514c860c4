-- The crowd's seeker with a Lua mind.
require "Steering";

local kHalfSide = 80;
local kNearSquared = 3;

local function Somewhere()
    return Vector.new(math.random(-kHalfSide, kHalfSide), 0, math.random(-kHalfSide, kHalfSide));
end

function Agent_Initialize(agent)
    Steering_CreateBody(agent);
    agent:SetPosition(Somewhere() + Vector.new(0, agent:GetHeight() / 2, 0));
    agent:SetTarget(Somewhere());
    agent:SetTargetRadius(1.5);
end

function Agent_Update(agent, deltaTimeInMillis)
    if (Vector.DistanceSquared(agent:GetPosition(), agent:GetTarget()) <= kNearSquared) then
        agent:SetTarget(Somewhere());
    end
    Steering_WalkToTarget(agent, deltaTimeInMillis);
    Core.DrawCircle(agent:GetTarget(), 0.4, Vector.new(0, 0.8, 1));
end
