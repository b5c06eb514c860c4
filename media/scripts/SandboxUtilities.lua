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

-- A building piece by its name; nil if there is none of that name.
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

-- A sun and a little light from everywhere.
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

-- Shoots a bullet from the camera: it flies almost straight and vanishes with a puff at the first thing it hits.
function SandboxUtilities_ShootBullet(sandbox)
    local forward = Sandbox.GetCameraForward(sandbox);
    local bullet = Sandbox.CreatePhysicsCapsule(sandbox, 0.3, 0.01);
    Core.SetMass(bullet, 0.1);
    Core.SetGravity(bullet, Vector.new(0, -0.01, 0));
    -- The capsule is upright: its y axis is turned to where it flies.
    Core.SetAxis(bullet, Sandbox.GetCameraLeft(sandbox), forward, Sandbox.GetCameraUp(sandbox));
    Core.SetPosition(bullet, Sandbox.GetCameraPosition(sandbox) + forward * 2);
    Core.SetParticleDirection(Core.CreateParticle(bullet, "Bullet"), forward);
    Core.ApplyImpulse(bullet, forward * 750);
    Sandbox.AddCollisionCallback(sandbox, bullet, OnBulletHit);
    return bullet;
end
