-- A seeker without rules: body and mind in one script.
require "Steering";

local kHalfSide = 50;

function Agent_Initialize(agent)
    Steering_CreateBody(agent);
    agent:SetTarget(Vector.new(kHalfSide, 0, 0));
    agent:SetTargetRadius(2.5);
end

function Agent_Update(agent, deltaTimeInMillis)
    Steering_WalkToTarget(agent, deltaTimeInMillis);
    local target = agent:GetTarget();
    if (Vector.Distance(agent:GetPosition(), target) < agent:GetTargetRadius()) then
        agent:SetTarget(Vector.new(
            math.random(-kHalfSide, kHalfSide), 0, math.random(-kHalfSide, kHalfSide)));
    end
    Steering_DrawGoal(agent, agent:GetTarget());
    Core.DrawSquare(Vector.new(), 2 * kHalfSide, Vector.new(1, 0, 0));
end
