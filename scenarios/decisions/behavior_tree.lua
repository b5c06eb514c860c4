-- SPDX-License-Identifier: BSD-2-Clause
-- Decisions: a guard whose mind is a behavior tree.
require "GuardWorld";

function Sandbox_Initialize(sandbox)
    GuardWorld_Initialize(sandbox, "BehaviorGuard.lua");
end
