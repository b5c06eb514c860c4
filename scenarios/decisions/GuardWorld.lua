-- SPDX-License-Identifier: BSD-2-Clause
-- A yard with a guard and an intruder. The scenarios of this folder differ only in the guard's script.
require "YardWorld";

function GuardWorld_Initialize(sandbox, guardScript)
    YardWorld_Initialize(sandbox, Vector.new(0, 35, -35));
    Sandbox.CreateAgent(sandbox, "Intruder.lua");
    Sandbox.CreateAgent(sandbox, guardScript);
end
