-- SPDX-License-Identifier: BSD-2-Clause
-- The knowledge of an agent, by name: values that were set, unless a knowledge source provides the value.
require "KnowledgeSource";

Blackboard = {};
Blackboard.__index = Blackboard;

function Blackboard.new(userData)
    return setmetatable({ userData_ = userData, values_ = {}, sources_ = {}, seen_ = {}, shown_ = {} }, Blackboard);
end

-- What users see of the blackboard: the last value of each name that was set or read.
local function ShowValue(board, attribute, value)
    if (board.seen_[attribute] == value) then
        return;
    end
    board.seen_[attribute] = value;
    local agent = Agent.Self();
    if (not agent) then
        return;
    end
    if (type(value) == "table") then
        value = #value .. (#value == 1 and " entry" or " entries");
    elseif (type(value) == "number") then
        value = math.floor(value * 100 + 0.5) / 100;
    end
    if (board.shown_[attribute] ~= value) then
        board.shown_[attribute] = value;
        agent:Show("blackboard", board.shown_);
    end
end

-- The value of the most confident source; the value that was set, if there is no source.
function Blackboard:Get(attribute)
    local best, highest;
    for _, source in ipairs(self.sources_[attribute] or {}) do
        local evaluation, confidence = source:Evaluate(self.userData_);
        if (not highest or confidence > highest) then
            best, highest = evaluation, confidence;
        end
    end
    if (highest) then
        ShowValue(self, attribute, best);
        return best;
    end
    return self.values_[attribute];
end

function Blackboard:Set(attribute, value)
    self.values_[attribute] = value;
    if (not self.sources_[attribute]) then
        ShowValue(self, attribute, value);
    end
end

function Blackboard:AddSource(attribute, source)
    self.sources_[attribute] = self.sources_[attribute] or {};
    table.insert(self.sources_[attribute], source);
end

function Blackboard:RemoveSource(attribute, source)
    local sources = self.sources_[attribute] or {};
    for index = #sources, 1, -1 do
        if (sources[index] == source) then
            table.remove(sources, index);
        end
    end
    if (#sources == 0) then
        self.sources_[attribute] = nil;
    end
end
