-- Walks to the middle of the plain, then stands still.
require "Steering";

local kPlace = Vector.new(0, 0, 0);
local kNearEnough = 1.0;

function Agent_Initialize(agent)
    Steering_CreateBody(agent);
    agent:SetPosition(Vector.new(10, 0, 10));
    agent:SetTarget(kPlace);
    agent:SetTargetRadius(kNearEnough);
end

function Agent_Update(agent, deltaTimeInMillis)
    local position = agent:GetPosition();
    position.y = 0;
    if (Vector.Distance(position, kPlace) > kNearEnough) then
        Steering_WalkToTarget(agent, deltaTimeInMillis);
    else
        Steering_Apply(agent, agent:ForceToTargetSpeed(0), deltaTimeInMillis);
    end
    Steering_DrawGoal(agent, kPlace);
end
