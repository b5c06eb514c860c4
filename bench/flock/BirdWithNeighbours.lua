-- SPDX-License-Identifier: BSD-2-Clause
-- Requests its neighbours in each step.
require "Bird";

Agent_Initialize = Bird_Initialize;

function Agent_Update(agent, milliseconds)
    Bird_Update(agent, milliseconds, agent:GetNeighbours(8, "flock"));
end
