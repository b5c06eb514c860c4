-- SPDX-License-Identifier: BSD-2-Clause
-- A sunlit plain of 200 by 200 m under a cloudy sky.

function Plain_Create(sandbox)
    Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0));
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 200, 200), "Ground2");
    Sandbox.SetAmbientLight(sandbox, Vector.new(0.3));
    local sun = Core.CreateDirectionalLight(sandbox, Vector.new(1, -1, 1));
    Core.SetLightDiffuse(sun, Vector.new(1.8, 1.4, 0.9));
    Core.SetLightSpecular(sun, Vector.new(1.8, 1.4, 0.9));
end
