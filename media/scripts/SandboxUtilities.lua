-- SPDX-License-Identifier: BSD-2-Clause
-- Building pieces, lights, and things to shoot.

SandboxUtilities = { Objects = {} };

local kFolder = "models/nobiax_modular/";

-- Masses in kg.
local kMasses = {
    modular_block = 15,
    modular_cooling = 15,
    modular_hangar_door = 100,
    modular_roof = 50
};
for _, stone in ipairs({ "brick", "concrete" }) do
    local prefix = "modular_" .. stone .. "_";
    kMasses[prefix .. "door"] = 80;
    kMasses[prefix .. "double_window"] = 80;
    kMasses[prefix .. "small_double_window"] = 80;
    kMasses[prefix .. "small_window_1"] = 80;
    kMasses[prefix .. "small_window_2"] = 40;
    kMasses[prefix .. "window_1"] = 80;
    kMasses[prefix .. "window_2"] = 40;
    for size, mass in ipairs({ 40, 30, 20 }) do
        kMasses["modular_pillar_" .. stone .. "_" .. size] = mass;
    end
    for size, mass in ipairs({ 80, 40, 30, 30, 20 }) do
        kMasses["modular_wall_" .. stone .. "_" .. size] = mass;
    end
end
for name, mass in pairs(kMasses) do
    SandboxUtilities.Objects[name] = { file = kFolder .. name .. ".mesh", mass = mass };
end

-- A fixed cube.
function SandboxUtilities_CreateBox(sandbox, size, position)
    local tiling = size * 0.5;
    local box = Sandbox.CreateBox(sandbox, size, size, size, tiling, tiling);
    Core.SetMass(box, 0);
    Core.SetPosition(box, position);
    Core.SetMaterial(box, "Ground2");
    return box;
end

-- A building piece by its name; nil for an unknown name.
function SandboxUtilities_CreateObject(sandbox, name, position, rotation)
    local template = SandboxUtilities.Objects[name];
    if (not template) then
        return nil;
    end
    local object = Sandbox.CreateObject(sandbox, template.file);
    Core.SetMass(object, template.mass);
    if (rotation) then
        Core.SetRotation(object, rotation);
    end
    if (position) then
        Core.SetPosition(object, position);
    end
    return object;
end

-- A sun and weak ambient light.
function SandboxUtilities_CreateLights(sandbox)
    Sandbox.SetAmbientLight(sandbox, Vector.new(0.3));
    local sun = Core.CreateDirectionalLight(sandbox, Vector.new(1, -1, 1));
    Core.SetLightDiffuse(sun, Vector.new(1.8, 1.4, 0.9));
    Core.SetLightSpecular(sun, Vector.new(1.8, 1.4, 0.9));
end

-- Throws a block from the camera.
function SandboxUtilities_ShootBox(sandbox)
    local forward = Sandbox.GetCameraForward(sandbox);
    local block = SandboxUtilities_CreateObject(
        sandbox, "modular_block",
        Sandbox.GetCameraPosition(sandbox) + forward * 2,
        Sandbox.GetCameraOrientation(sandbox));
    Core.ApplyImpulse(block, forward * 15000);
    Core.ApplyAngularImpulse(block, Sandbox.GetCameraLeft(sandbox) * 10);
    return block;
end

local function OnBulletHit(sandbox, collision)
    Sandbox.RemoveObject(sandbox, collision.objectA);
    local impact = Core.CreateParticle(sandbox, "BulletImpact");
    Core.SetPosition(impact, collision.pointA);
    Core.SetParticleDirection(impact, collision.normalOnB);
end

-- Shoots a bullet from the camera. It flies almost straight, and disappears with a puff at the first hit.
function SandboxUtilities_ShootBullet(sandbox)
    local forward = Sandbox.GetCameraForward(sandbox);
    local bullet = Sandbox.CreatePhysicsCapsule(sandbox, 0.3, 0.01);
    Core.SetMass(bullet, 0.1);
    Core.SetGravity(bullet, Vector.new(0, -0.01, 0));
    -- The capsule is upright: its y axis is rotated to the direction of flight.
    Core.SetAxis(bullet, Sandbox.GetCameraLeft(sandbox), forward, -Sandbox.GetCameraUp(sandbox));
    Core.SetPosition(bullet, Sandbox.GetCameraPosition(sandbox) + forward * 2);
    Core.SetParticleDirection(Core.CreateParticle(bullet, "Bullet"), forward);
    Core.ApplyImpulse(bullet, forward * 750);
    Sandbox.AddCollisionCallback(sandbox, bullet, OnBulletHit);
    return bullet;
end

-- The level: a floor at y = 0 with two terraces at y = 4, a basin at y = -2 next to it, ramps between them, and blocks
-- as obstacles. Each entry is a cube: its edge length and its centre.
local function Row(cubes, size, y, x, z, step, count)
    for index = 0, count - 1 do
        table.insert(cubes, { size = size, center = Vector.new(x + step.x * index, y, z + step.z * index) });
    end
end

local function LevelCubes()
    local cubes = {};
    local east, north = { x = 1, z = 0 }, { x = 0, z = 1 };
    local function Along(direction, distance)
        return { x = direction.x * distance, z = direction.z * distance };
    end
    -- Floor and basin.
    for row = 0, 3 do
        Row(cubes, 20, -10, -20, 20 * row, Along(east, 20), 3);
    end
    Row(cubes, 20, -12, 40, 0, Along(north, 20), 4);
    Row(cubes, 8, -6, 54, -6, Along(north, 8), 10);
    -- Terraces with parapets at their edges.
    for row = 0, 2 do
        Row(cubes, 4, 2, -26, 24 + 4 * row, Along(east, 4), 6);
        Row(cubes, 4, 2, 12, 48 + 4 * row, Along(east, 4), 4);
    end
    Row(cubes, 2, 5, -27, 33, Along(east, 2), 12);
    Row(cubes, 2, 5, -27, 23, Along(north, 2), 5);
    Row(cubes, 2, 5, 11, 57, Along(east, 2), 8);
    -- Blocks: x and z of each.
    local blocks = {
        { size = 4, y = 2, places = {
            -26, -6, -26, 0, -14, -6, -4, -6, 8, -6, 20, -6, 26, 0, 26, 8, 22, 16, 24, 28, 26, 36, -26, 42, -16, 42, -16, 60
        } },
        { size = 6, y = 3, places = { -24, 52, -8, 60, 3, 65, 25, 65, -26, 66, -10, 16 } },
        { size = 6, y = 1, places = { 44, 12, 44, 48 } },
        { size = 8, y = 3, places = { 4, 14, -24, 60, 16, 66 } }
    };
    for _, kind in ipairs(blocks) do
        for index = 1, #kind.places, 2 do
            Row(cubes, kind.size, kind.y, kind.places[index], kind.places[index + 1], Along(east, 0), 1);
        end
    end
    return cubes;
end

-- A cube of 8 m, rotated so that one of its sides is a ramp that ends at the edge `top` and rises along x or z.
local function CreateRamp(sandbox, top, degrees, along)
    local size = 8;
    local angle = math.rad(degrees);
    local rotation = Vector.new(-degrees * along.z, 0, degrees * along.x);
    local forward = Vector.new(along.x, 0, along.z);
    local middle = top - forward * (size / 2 * math.cos(angle)) - Vector.new(0, size / 2 * math.sin(angle), 0);
    local normal = Vector.new(0, math.cos(angle), 0) - forward * math.sin(angle);
    local ramp = SandboxUtilities_CreateBox(sandbox, size, middle - normal * (size / 2));
    Core.SetRotation(ramp, rotation);
    return ramp;
end

-- 113 fixed cubes, a plane below them, a sky and lights.
function SandboxUtilities_CreateLevel(sandbox)
    for _, cube in ipairs(LevelCubes()) do
        SandboxUtilities_CreateBox(sandbox, cube.size, cube.center);
    end
    CreateRamp(sandbox, Vector.new(-22, 4, 22), 30, { x = 0, z = 1 });
    CreateRamp(sandbox, Vector.new(-4, 4, 28), 30, { x = -1, z = 0 });
    CreateRamp(sandbox, Vector.new(18, 4, 46), 30, { x = 0, z = 1 });
    CreateRamp(sandbox, Vector.new(10, 4, 52), 30, { x = 1, z = 0 });
    for z = 0, 60, 30 do
        CreateRamp(sandbox, Vector.new(30, 0, z), 15, { x = -1, z = 0 });
    end

    local ground = Sandbox.CreatePlane(sandbox, 200, 200);
    Core.SetPosition(ground, Vector.new(0, -10, 0));
    Core.SetMaterial(ground, "Ground2");
    Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0));
    SandboxUtilities_CreateLights(sandbox);
end

-- A round trip through the level, over both terraces: 21 points.
function SandboxUtilities_GetLevelPath()
    local places = {
        { 0, 0, 0 }, { -10, 0, 6 }, { -22, 0, 10 }, { -22, 0, 14 }, { -22, 4, 23 }, { -22, 4, 28 }, { -14, 4, 28 },
        { -5, 4, 28 }, { 4, 0, 28 }, { 3, 0, 34 }, { -1, 0, 40 }, { -3, 0, 47 }, { 1, 0, 52 }, { 11, 4, 52 },
        { 18, 4, 52 }, { 18, 4, 47 }, { 18, 0, 38 }, { 14, 0, 32 }, { 14, 0, 22 }, { 12, 0, 10 }, { 5, 0, 3 }
    };
    local path = {};
    for index, place in ipairs(places) do
        path[index] = Vector.new(place[1], place[2], place[3]);
    end
    return path;
end
