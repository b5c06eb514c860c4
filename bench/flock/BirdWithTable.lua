-- SPDX-License-Identifier: BSD-2-Clause
-- Keeps a table of the agents of its team.
require "Bird";

Agent_Initialize = Bird_Initialize;

local others;

function Agent_Update(agent, milliseconds)
    if (not others) then
        others = {};
        for _, other in ipairs(Sandbox.GetAgents(agent:GetSandbox())) do
            if (other:GetTeam() == "flock") then
                table.insert(others, other);
            end
        end
    end
    Bird_Update(agent, milliseconds, others);
end
