-- SPDX-License-Identifier: BSD-2-Clause
-- Draws for one step what agents and objects are doing.

local function Color(red, green, blue)
    return Vector.new(red, green, blue);
end

DebugUtilities = {
    Black = Color(0, 0, 0),
    White = Color(1, 1, 1),
    Red = Color(1, 0, 0),
    Green = Color(0, 1, 0),
    Blue = Color(0, 0, 1),
    Orange = Color(1, 0.5, 0)
};

-- Connects the points with lines, moved by `offset`; a cyclic path is closed. The default color is green.
function DebugUtilities_DrawPath(points, cyclic, offset, color)
    local from;
    local function LineTo(point)
        local to = offset and point + offset or point;
        if (from) then
            Core.DrawLine(from, to, color or DebugUtilities.Green);
        end
        from = to;
    end
    for _, point in ipairs(points) do
        LineTo(point);
    end
    if (cyclic and #points > 2) then
        LineTo(points[1]);
    end
end

-- Draws the paths of all living agents that have one, each with a sphere at its target.
function DebugUtilities_DrawPaths(agents)
    local lift = Vector.new(0, 0.02, 0);
    for _, agent in ipairs(agents) do
        local path = agent:GetHealth() > 0 and agent:GetPath() or {};
        if (#path > 0) then
            DebugUtilities_DrawPath(path, false, lift);
            Core.DrawSphere(agent:GetTarget(), 0.1, DebugUtilities.Red, true);
        end
    end
end

-- Draws around each object for which `fits` returns true, or around all.
local function DrawAround(objects, fits)
    for _, object in ipairs(objects) do
        if (not fits or fits(object)) then
            DebugUtilities_DrawBoundingSphere(object);
        end
    end
end

function DebugUtilities_DrawBoundingSphere(object)
    Core.DrawSphere(Core.GetPosition(object), Core.GetRadius(object), DebugUtilities.Red);
end

function DebugUtilities_DrawBoundingSpheres(objects)
    DrawAround(objects);
end

function DebugUtilities_DrawDynamicBoundingSpheres(objects)
    DrawAround(objects, function(object) return Core.GetMass(object) > 0; end);
end
