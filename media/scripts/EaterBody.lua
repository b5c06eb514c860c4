-- SPDX-License-Identifier: BSD-2-Clause
-- The appearance of eaters.

local kEyes = { -1, 1 };

local function Ball(parent, radius, place, material)
    local node = Core.CreateCapsule(parent, 2 * radius, radius);
    Core.SetPosition(node, place);
    Core.SetMaterial(node, material);
end

-- A sphere with eyes and a mouth.
function EaterBody_Dress(agent, material)
    Ball(agent, 0.62, Vector.new(0, -0.12, 0), material);
    for _, side in ipairs(kEyes) do
        Ball(agent, 0.17, Vector.new(side * 0.25, 0.25, 0.4), "White");
        Ball(agent, 0.09, Vector.new(side * 0.26, 0.29, 0.52), "Soarbox/Black");
    end
    local mouth = Core.CreateBox(agent, 0.62, 0.12, 0.3);
    Core.SetPosition(mouth, Vector.new(0, -0.16, 0.42));
    Core.SetMaterial(mouth, "Soarbox/Black");
end
