-- SPDX-License-Identifier: BSD-2-Clause
-- Decisions: a guard whose mind is a decision tree.
require "GuardWorld";

function Sandbox_Initialize(sandbox)
    GuardWorld_Initialize(sandbox, "TreeGuard.lua");
end
