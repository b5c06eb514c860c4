-- SPDX-License-Identifier: BSD-2-Clause
-- Knowledge: foragers look for berries. Each has a blackboard whose sources know the next berries: what it sees, what it
-- remembers, and, least certain, a rumor. Berries that are picked grow again elsewhere.
require "YardWorld";

local kBushes = 6;
local bushes = {};

local function Grow(bush)
    bush.position = Vector.new(math.random(-30, 30), 0.3, math.random(-30, 30));
    Core.SetPosition(bush.node, bush.position);
end

local function OnEvent(sandbox, _, type, event)
    if (type == "Pick") then
        for _, bush in ipairs(bushes) do
            if (Vector.Distance(bush.position, event.position) < 0.1) then
                Grow(bush);
                Sandbox.AddEvent(sandbox, "Picked", { agent = event.agent, position = event.position });
            end
        end
    end
end

function Sandbox_Initialize(sandbox)
    YardWorld_Initialize(sandbox, Vector.new(0, 40, -40));
    for index = 1, kBushes do
        local node = Core.CreateCapsule(sandbox, 0.6, 0.3);
        Core.SetMaterial(node, "Blue");
        bushes[index] = { node = node };
        Grow(bushes[index]);
    end
    Sandbox.AddEventCallback(sandbox, sandbox, OnEvent);
    for _ = 1, 3 do
        Sandbox.CreateAgent(sandbox, "Forager.lua");
    end
end

-- Bushes announce their positions; foragers decide which of them they can see.
function Sandbox_Update(sandbox)
    GUI_UpdateUI(sandbox);
    for _, bush in ipairs(bushes) do
        Sandbox.AddEvent(sandbox, "Bush", { position = bush.position });
    end
end
