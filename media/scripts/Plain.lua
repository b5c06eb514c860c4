-- SPDX-License-Identifier: BSD-2-Clause
-- Open country: a wide plain with a low sun and a sky with clouds.

local kSide = 200;

local function Sun(sandbox)
    local sun = Core.CreateDirectionalLight(sandbox, Vector.new(0.7, -1, 0.5));
    Core.SetLightDiffuse(sun, Vector.new(1.8, 1.7, 1.45));
    Core.SetLightSpecular(sun, Vector.new(1.8, 1.7, 1.45));
end

-- Creates the plain; returns its ground.
function Plain_Create(sandbox)
    local ground = Sandbox.CreatePlane(sandbox, kSide, kSide);
    Core.SetMaterial(ground, "Ground2");
    Sun(sandbox);
    Sandbox.SetAmbientLight(sandbox, Vector.new(0.32, 0.33, 0.36));
    Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0));
    return ground;
end
