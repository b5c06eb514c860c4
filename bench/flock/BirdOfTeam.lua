-- SPDX-License-Identifier: BSD-2-Clause
-- Passes the name of its team.
require "Bird";

Agent_Initialize = Bird_Initialize;

function Agent_Update(agent, milliseconds)
    Bird_Update(agent, milliseconds, "flock");
end
