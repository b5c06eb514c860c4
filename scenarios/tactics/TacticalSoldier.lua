-- SPDX-License-Identifier: BSD-2-Clause
-- The library's soldier, who prints what it does and when it is hit.
require "IndirectSoldierAgent";

local lastDeed, lastHealth;
local update = Agent_Update;

function Agent_Update(agent, deltaTimeInMillis)
    update(agent, deltaTimeInMillis);
    local deed = IndirectSoldier.mind:GetCurrentActionName();
    if (deed and deed ~= lastDeed) then
        print(agent:GetId() .. " " .. deed);
        lastDeed = deed;
    end
    if (lastHealth and agent:GetHealth() < lastHealth) then
        print(agent:GetId() .. " is hit");
    end
    lastHealth = agent:GetHealth();
end
