-- SPDX-License-Identifier: BSD-2-Clause
-- A yard with a guard and an intruder. The guard's script is what the scenarios of this folder differ in.
require "YardWorld";

function GuardWorld_Initialize(sandbox, guardScript)
    YardWorld_Initialize(sandbox, Vector.new(0, 35, -35));
    Sandbox.CreateAgent(sandbox, "Intruder.lua");
    Sandbox.CreateAgent(sandbox, guardScript);
end
