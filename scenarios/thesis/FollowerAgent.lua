-- Body of the Soar follower (followeragent.soar): on "follow" it closes up to its leader, on "stop" it only makes room.
require "Steering";

local leader;

function Agent_Initialize(agent)
    Steering_CreateBody(agent);
    agent:SetPosition(Vector.new(math.random(-50, 50), 0, math.random(-50, 50)));
    leader = Steering_FirstOther(agent);
    agent:SetLeader(leader);
end

function Agent_Update(agent, deltaTimeInMillis, soarCommand)
    if (soarCommand == "follow") then
        Steering_Follow(agent, leader, deltaTimeInMillis);
    elseif (soarCommand == "stop") then
        Steering_Apply(agent, agent:ForceToSeparate(3, 45, { leader }), deltaTimeInMillis);
    end
    Core.DrawCircle(agent:GetPosition(), 1, Vector.new(1, 1, 0));
    Core.DrawLine(agent:GetPosition(), leader:GetPosition(), Vector.new(0, 1, 0));
end
