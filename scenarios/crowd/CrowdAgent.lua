-- A Soar seeker that starts anywhere on the plain and draws nothing but its goal.
require "Steering";

local kHalfSide = 80;

local function Somewhere()
    return Vector.new(math.random(-kHalfSide, kHalfSide), 0, math.random(-kHalfSide, kHalfSide));
end

function Agent_Initialize(agent)
    Steering_CreateBody(agent);
    agent:SetPosition(Somewhere() + Vector.new(0, agent:GetHeight() / 2, 0));
    agent:SetTarget(Somewhere());
    agent:SetTargetRadius(1.5);
end

function Agent_Update(agent, deltaTimeInMillis, soarCommand)
    if (soarCommand == "newtarget") then
        agent:SetTarget(Somewhere());
    end
    Steering_WalkToTarget(agent, deltaTimeInMillis);
    Core.DrawCircle(agent:GetTarget(), 0.4, Vector.new(1, 0.8, 0));
end
