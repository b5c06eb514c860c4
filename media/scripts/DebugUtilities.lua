-- SPDX-License-Identifier: BSD-2-Clause
-- Lines and spheres that show what agents are about. What is drawn lasts for one step.

DebugUtilities = {
    Black = Vector.new(0, 0, 0),
    Blue = Vector.new(0, 0, 1),
    Green = Vector.new(0, 1, 0),
    Orange = Vector.new(1, 0.65, 0),
    Red = Vector.new(1, 0, 0),
    White = Vector.new(1, 1, 1)
};

-- Lines from point to point, and back to the first one if the path is cyclic.
function DebugUtilities_DrawPath(points, cyclic, offset, color)
    offset = offset or Vector.new();
    color = color or DebugUtilities.Green;

    for index = 2, #points do
        Core.DrawLine(points[index - 1] + offset, points[index] + offset, color);
    end
    if (cyclic and #points > 2) then
        Core.DrawLine(points[#points] + offset, points[1] + offset, color);
    end
end

-- The path and the target of each agent that lives and has a path.
function DebugUtilities_DrawPaths(agents)
    for index = 1, #agents do
        local agent = agents[index];
        if (agent:GetHealth() > 0 and agent:HasPath()) then
            DebugUtilities_DrawPath(agent:GetPath(), false, Vector.new(0, 0.02, 0));
            Core.DrawSphere(agent:GetTarget(), 0.1, DebugUtilities.Red, true);
        end
    end
end

function DebugUtilities_DrawBoundingSphere(object)
    Core.DrawSphere(Core.GetPosition(object), Core.GetRadius(object), DebugUtilities.Red);
end

function DebugUtilities_DrawBoundingSpheres(objects)
    for index = 1, #objects do
        DebugUtilities_DrawBoundingSphere(objects[index]);
    end
end

-- The spheres of the objects that can move.
function DebugUtilities_DrawDynamicBoundingSpheres(objects)
    for index = 1, #objects do
        if (Core.GetMass(objects[index]) > 0) then
            DebugUtilities_DrawBoundingSphere(objects[index]);
        end
    end
end
