-- SPDX-License-Identifier: BSD-2-Clause
-- Boxes and treats of Eaters, for maps that have them. EatersRules.lua calls these.
--
-- A box { x, y, id, color, shape, points } stays closed until an eater in its cell opens it, which brings its points once.
-- `isInfo`: opened, it says which reward box is the right one, and with which code that is to be opened, if any is needed
-- (`needsCode`). `reward`: a reward box; the right one brings that many points and ends the game; it brings `wrongCode`
-- with another code, and each other box takes one point. A treat { x, y, points } brings its points to each eater that
-- comes into its cell, and stays.
require "GridBoard";

EatersBoxes = {};

local kHighestCode, kWrongBox, kWrongCode = 3, -1, 1;

-- Puts the boxes of the settings on the board, and chooses the right one among those with a reward.
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

-- What an eater gets that has moved, or tried to.
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

-- Opens the box in the eater's cell, if it wants that and the box is closed.
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

-- Whether no box keeps the game going.
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
