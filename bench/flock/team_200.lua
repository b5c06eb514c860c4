-- SPDX-License-Identifier: BSD-2-Clause
require "Flock";

function Sandbox_Initialize(sandbox)
    Flock_Create(sandbox, 200, "BirdOfTeam.lua");
end
