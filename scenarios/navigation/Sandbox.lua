-- SPDX-License-Identifier: BSD-2-Clause
-- Navigation: five walkers go from place to place on the level, over ramps and around blocks. F3 hides the mesh that they
-- find their ways on.
require "LevelWorld";

function Sandbox_Initialize(sandbox)
    LevelWorld_Initialize(sandbox, Vector.new(15, 65, 15), Vector.new(-90, 0, 180), 100);
    LevelWorld_HandleEvent(sandbox, { source = "keyboard", key = "f3_key", pressed = true });
    for _ = 1, 5 do
        LevelWorld_PutAgent(Sandbox.CreateAgent(sandbox, "WalkingAgent.lua"), LevelWorld_RandomPlace(sandbox));
    end
end

function Sandbox_Update(sandbox)
    GUI_UpdateUI(sandbox);
end

function Sandbox_HandleEvent(sandbox, event)
    LevelWorld_HandleEvent(sandbox, event);
end
