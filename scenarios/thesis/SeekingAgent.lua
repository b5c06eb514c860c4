-- Body of the Soar seeker (seekingagent.soar): walks to its target; on "newtarget" it picks another.
require "Steering";

local kHalfSide = 50;

function Agent_Initialize(agent)
    Steering_CreateBody(agent);
    agent:SetTarget(Vector.new(kHalfSide, 0, 0));
    agent:SetTargetRadius(2.5);
end

function Agent_Update(agent, deltaTimeInMillis, soarCommand)
    Steering_WalkToTarget(agent, deltaTimeInMillis);
    if (soarCommand == "newtarget") then
        agent:SetTarget(Vector.new(
            math.random(-kHalfSide, kHalfSide), 0, math.random(-kHalfSide, kHalfSide)));
    end
    Steering_DrawGoal(agent, agent:GetTarget());
    Core.DrawSquare(Vector.new(), 2 * kHalfSide, Vector.new(1, 0, 0));
end
