-- SPDX-License-Identifier: BSD-2-Clause
-- Decisions: a guard whose mind is a state machine.
require "GuardWorld";

function Sandbox_Initialize(sandbox)
    GuardWorld_Initialize(sandbox, "StateGuard.lua");
end
