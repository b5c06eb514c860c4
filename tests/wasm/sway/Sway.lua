-- SPDX-License-Identifier: BSD-2-Clause
require "AgentUtilities";
local x = 0.3;
function Agent_Initialize(agent) end
function Agent_Update(agent)
    for _ = 1, 20 do x = 3.05 * math.sin(x) end
    agent:SetForward(Vector.new(math.sin(x), 0, math.cos(x)));
end
