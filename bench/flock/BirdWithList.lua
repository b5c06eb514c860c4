-- SPDX-License-Identifier: BSD-2-Clause
-- Requests the list of all agents in each step.
require "Bird";

Agent_Initialize = Bird_Initialize;

function Agent_Update(agent, milliseconds)
    Bird_Update(agent, milliseconds, Sandbox.GetAgents(agent:GetSandbox()));
end
