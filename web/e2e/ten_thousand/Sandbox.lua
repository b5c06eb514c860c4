-- SPDX-License-Identifier: BSD-2-Clause
-- 10,000 bodies of four shapes and eight materials. A tenth of them moves in each tick.
local kSide, kSpacing_m, kMoving = 100, 1.8, 10;
local kMaterials = { "White", "Red", "Green", "Blue", "Soarbox/Gold", "Soarbox/Yellow", "Soarbox/Crate", "Soarbox/Stone" };
local kShapes = {
    function(sandbox) return Core.CreateBox(sandbox, 0.8, 0.8, 0.8); end,
    function(sandbox) return Core.CreateBox(sandbox, 0.4, 1.4, 0.4); end,
    function(sandbox) return Core.CreateCylinder(sandbox, 1, 0.4); end,
    function(sandbox) return Core.CreateCapsule(sandbox, 1.2, 0.3); end,
};
local bodies, places = {}, {};

function Sandbox_Initialize(sandbox)
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 200, 200), "Ground2");
    Sandbox.SetAmbientLight(sandbox, Vector.new(0.3));
    Core.CreateDirectionalLight(sandbox, Vector.new(1, -1, 1));
    for row = 1, kSide do
        for column = 1, kSide do
            local number = #bodies + 1;
            bodies[number] = kShapes[number % #kShapes + 1](sandbox);
            places[number] = Vector.new((column - kSide / 2) * kSpacing_m, 0.7, (row - kSide / 2) * kSpacing_m);
            Core.SetMaterial(bodies[number], kMaterials[(row * 3 + math.floor(column / 4)) % #kMaterials + 1]);
            Core.SetPosition(bodies[number], places[number]);
        end
    end
    Sandbox.CreateAgent(sandbox, "Walker.lua");
end

function Sandbox_Update(sandbox, deltaTimeInMillis)
    local seconds = Sandbox.GetTimeInMillis(sandbox) / 1000;
    for number = 1, #bodies, kMoving do
        local place = places[number];
        Core.SetPosition(bodies[number], Vector.new(place.x, 0.9 + 0.4 * math.sin(2 * seconds + number), place.z));
        Core.SetRotation(bodies[number], Vector.new(0, 60 * seconds + number, 0));
    end
end
