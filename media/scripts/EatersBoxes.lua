-- SPDX-License-Identifier: BSD-2-Clause
-- Boxes and treats of Eaters, for maps with such objects. EatersRules.lua calls these functions.
--
-- A box { x, y, id, color, shape, points } stays closed until an eater in its cell opens it, which gives its points
-- once. `isInfo`: when opened, it says which reward box is the right one, and the code for opening it, if one is needed
-- (`needsCode`). `reward`: a reward box. The right one gives this number of points and ends the game; with another code
-- it gives `wrongCode`; each other box costs one point. A treat { x, y, points } gives its points to each eater that
-- enters its cell, and stays.
require "GridBoard";

EatersBoxes = {};

local kHighestCode, kWrongBox, kWrongCode = 3, -1, 1;

-- Puts the boxes of the settings on the board, and chooses the right one among the reward boxes.
function EatersBoxes.Place(game)
    local placed, rewards, info = {}, {}, nil;
    for i, box in ipairs(game.boxes) do
        local own = {};
        for name, value in pairs(box) do
            own[name] = value;
        end
        placed[i] = own;
        if (own.reward) then
            rewards[#rewards + 1] = own;
            own.number = #rewards;
        end
        info = own.isInfo and own or info;
    end
    game.boxes = placed;
    if (#rewards > 0) then
        local right = rewards[game.random(#rewards)];
        right.isRight = true;
        right.code = info and info.needsCode and game.random(kHighestCode) or nil;
        game.rightBox = right;
    end
end

-- The effects on an eater that has moved, or has tried to.
function EatersBoxes.Take(game, eater)
    for _, treat in ipairs(eater.wish and game.treats or {}) do
        if (treat.x == eater.x and treat.y == eater.y) then
            eater.score = eater.score + treat.points;
        end
    end
end

local function RewardOf(box, code)
    if (not box.isRight) then
        return kWrongBox;
    end
    return (not box.code or box.code == code) and box.reward or (box.wrongCode or kWrongCode);
end

-- Opens the box in the eater's cell, if the eater wants this and the box is closed.
function EatersBoxes.Open(game, eater)
    local box = eater.opens and GridBoard.At(game.boxes, eater.x, eater.y);
    if (not box or box.isOpen) then
        return;
    end
    box.isOpen, box.openCode = true, eater.code;
    eater.score = eater.score + (box.points or 0) + (box.reward and RewardOf(box, eater.code) or 0);
    game.isWon = game.isWon or box.isRight;
    if (box.isInfo and game.rightBox) then
        box.tells, box.tellsCode = game.rightBox.number, game.rightBox.code;
    end
end

-- True if no box prevents the end of the game.
function EatersBoxes.AllOpen(game)
    for _, box in ipairs(game.boxes) do
        if (not box.isOpen and not game.isWon) then
            return false;
        end
    end
    return true;
end

function EatersBoxes.Percepts(box, isNew)
    return {
        box = "true", id = box.id, color = box.color, shape = box.shape, status = box.isOpen and "open" or nil,
        ["box-id"] = box.number, ["positive-box-id"] = box.tells, ["open-code"] = box.tellsCode or box.openCode,
        _new = isNew
    };
end
