-- A follower without rules: closes up to its leader until it is near.
require "Steering";

local kNearSquared = 5;
local leader;

function Agent_Initialize(agent)
    Steering_CreateBody(agent);
    agent:SetPosition(Vector.new(math.random(-50, 50), 0, math.random(-50, 50)));
    leader = Steering_FirstOther(agent);
end

function Agent_Update(agent, deltaTimeInMillis)
    if (Vector.DistanceSquared(agent:GetPosition(), leader:GetPosition()) > kNearSquared) then
        Steering_Follow(agent, leader, deltaTimeInMillis);
    else
        Steering_Apply(agent, agent:ForceToSeparate(3, 45, { leader }), deltaTimeInMillis);
    end
    Core.DrawCircle(agent:GetPosition(), 1, Vector.new(0, 1, 1));
    Core.DrawLine(agent:GetPosition(), leader:GetPosition(), Vector.new(0, 1, 0));
end
