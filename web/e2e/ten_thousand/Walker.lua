-- SPDX-License-Identifier: BSD-2-Clause
-- Walks straight on.
function Agent_Initialize(agent)
    Core.CreateCapsule(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(0, 1, 0));
end

function Agent_Update(agent, deltaTimeInMillis)
    agent:ApplyForce(Vector.new(60, 0, 20));
end
