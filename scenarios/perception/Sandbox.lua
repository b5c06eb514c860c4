-- SPDX-License-Identifier: BSD-2-Clause
-- Perception: two watchers turn about behind walls, thieves walk past. A watcher sees thieves in its field of view that
-- no wall hides, and informs its team, so that both watchers know. Green lines are seen, red ones hidden.
require "YardWorld";

local function Wall(sandbox, x, z, width, length)
    local wall = Sandbox.CreateBox(sandbox, width, 3, length);
    Core.SetMass(wall, 0);
    Core.SetPosition(wall, Vector.new(x, 1.5, z));
    Core.SetMaterial(wall, "Ground2");
end

function Sandbox_Initialize(sandbox)
    YardWorld_Initialize(sandbox, Vector.new(0, 40, -35));
    Wall(sandbox, 0, 0, 1, 30);
    Wall(sandbox, -10, 10, 8, 1);
    Wall(sandbox, 10, -10, 8, 1);
    for _, x in ipairs({ -8, 8 }) do
        Sandbox.CreateAgent(sandbox, "Watcher.lua"):SetPosition(Vector.new(x, 0.8, 0));
    end
    for _, x in ipairs({ -14, 14 }) do
        local thief = Sandbox.CreateAgent(sandbox, "Thief.lua");
        thief:SetPosition(Vector.new(x, 0.8, -18));
        thief:SetTarget(Vector.new(x, 0.8, 18));
    end
end
