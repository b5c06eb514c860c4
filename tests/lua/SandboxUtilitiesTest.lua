-- SPDX-License-Identifier: BSD-2-Clause
-- The level and its path.
require "Check";
require "SandboxUtilities";

local tests = {};

function tests.TheLevelIsMadeOfFixedCubesAndCanBeWalkedAlongItsPath()
    local before = #Sandbox.GetObjects(sandbox);
    SandboxUtilities_CreateLevel(sandbox);
    local objects = Sandbox.GetObjects(sandbox);
    CheckEqual(114, #objects - before);
    for index = before + 1, #objects do
        CheckEqual(0, Core.GetMass(objects[index]));
    end
    Sandbox.CreateNavigationMesh(sandbox, "level", {
        WalkableRadius = 0.4, WalkableClimbHeight = 0.2, MinimumRegionArea = 100 });
    local path = SandboxUtilities_GetLevelPath();
    CheckEqual(21, #path);
    local highest = 0;
    for index, from in ipairs(path) do
        local to = path[index % #path + 1];
        local way = Sandbox.FindPath(sandbox, "level", from, to);
        Check(#way > 1, "there is no way from point " .. index);
        local length = 0;
        for step = 2, #way do
            length = length + Vector.Distance(way[step - 1], way[step]);
        end
        Check(length < 1.15 * Vector.Distance(from, to) + 0.5, "the way from point " .. index .. " is not straight");
        highest = math.max(highest, way[#way].y);
    end
    CheckNear(4, highest, 0.2);
    -- There is a path down into the basin.
    Check(#Sandbox.FindPath(sandbox, "level", Vector.new(), Vector.new(45, -2, 30)) > 1);
end

function tests.ThingsAreShotAlongTheCamera()
    Sandbox.SetCameraPosition(sandbox, Vector.new(0, 30, 0));
    local block = SandboxUtilities_ShootBox(sandbox);
    CheckNear(15, Core.GetMass(block));
    CheckNear(2, Vector.Distance(Core.GetPosition(block), Sandbox.GetCameraPosition(sandbox)), 0.01);
    SandboxUtilities_ShootBullet(sandbox);
end

RunTests(tests);
