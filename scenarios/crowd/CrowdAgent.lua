-- A Soar seeker that starts anywhere on the plain and draws nothing but its goal.
require "CrowdBody";

local kGoalColor = Vector.new(1, 0.8, 0);

function Agent_Initialize(agent)
    CrowdBody_Create(agent);
end

function Agent_Update(agent, deltaTimeInMillis, soarCommand)
    if (soarCommand == "newtarget") then
        agent:SetTarget(CrowdBody_Somewhere());
    end
    Steering_WalkToTarget(agent, deltaTimeInMillis);
    Core.DrawCircle(agent:GetTarget(), 0.4, kGoalColor);
end
