-- SPDX-License-Identifier: BSD-2-Clause
-- Passes nothing: all agents.
require "Bird";

Agent_Initialize = Bird_Initialize;

function Agent_Update(agent, milliseconds)
    Bird_Update(agent, milliseconds, nil);
end
