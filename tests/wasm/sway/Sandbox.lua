-- SPDX-License-Identifier: BSD-2-Clause
-- An agent whose heading depends on the last bit of a sine: each error grows threefold in a step.
require "YardWorld";
function Sandbox_Initialize(sandbox)
    YardWorld_Initialize(sandbox, Vector.new(0, 40, -35));
    Sandbox.CreateAgent(sandbox, "Sway.lua"):SetPosition(Vector.new(0, 0.8, 0));
end
