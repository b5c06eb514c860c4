-- SPDX-License-Identifier: BSD-2-Clause
-- What all agents of the flock do, whatever they pass to the forces.
function Bird_Initialize(agent)
    agent:SetTeam("flock");
    agent:SetMass(40);
    agent:SetMaxForce(400);
    agent:SetMaxSpeed(4);
end

function Bird_Update(agent, milliseconds, others)
    local force = agent:ForceToSeparate(2, 180, others) * 1.5 + agent:ForceToCombine(8, 180, others) * 0.5 +
        agent:ForceToAlign(8, 180, others) * 0.5;
    agent:Push(force, milliseconds / 1000);
end
