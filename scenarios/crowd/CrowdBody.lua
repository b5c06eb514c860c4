-- What the crowd's two kinds of seekers share: where they may go, and how they begin.
require "Steering";

local kHalfSide = 80;

-- Any whole-metre place on the plain.
function CrowdBody_Somewhere()
    return Vector.new(math.random(-kHalfSide, kHalfSide), 0, math.random(-kHalfSide, kHalfSide));
end

function CrowdBody_Create(agent)
    Steering_CreateBody(agent);
    agent:SetPosition(CrowdBody_Somewhere() + Vector.new(0, agent:GetHeight() / 2, 0));
    agent:SetTarget(CrowdBody_Somewhere());
    agent:SetTargetRadius(1.5);
end
