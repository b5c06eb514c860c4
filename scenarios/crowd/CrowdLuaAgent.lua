-- The crowd's seeker with a Lua mind.
require "CrowdBody";

local kNearSquared = 3;
local kGoalColor = Vector.new(0, 0.8, 1);

function Agent_Initialize(agent)
    CrowdBody_Create(agent);
end

function Agent_Update(agent, deltaTimeInMillis)
    if (Vector.DistanceSquared(agent:GetPosition(), agent:GetTarget()) <= kNearSquared) then
        agent:SetTarget(CrowdBody_Somewhere());
    end
    Steering_WalkToTarget(agent, deltaTimeInMillis);
    Core.DrawCircle(agent:GetTarget(), 0.4, kGoalColor);
end
