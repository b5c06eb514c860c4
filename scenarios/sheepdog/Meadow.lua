-- SPDX-License-Identifier: BSD-2-Clause
-- The meadow as numbers: where the pen and its gate are, how wide the meadow is. Sheep, dog and world agree on them.
Meadow = {
    HalfWidth = 34,                             -- Sheep turn back here.
    Gate = Vector.new(0, 0, 22),                -- In front of the gate.
    Pen = Vector.new(0, 0, 33),                 -- The middle of the pen.
    PenHalfWidth = 7, PenBegin = 26, PenEnd = 40,
    GateHalfWidth = 3
};

-- Whether a place is in the pen, and not just in the gate.
function Meadow.IsInPen(place)
    return math.abs(place.x) < Meadow.PenHalfWidth and place.z > Meadow.PenBegin + 0.5 and place.z < Meadow.PenEnd;
end
