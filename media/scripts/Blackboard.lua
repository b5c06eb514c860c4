-- SPDX-License-Identifier: BSD-2-Clause
-- What an agent knows, by name: what it was told (Set), unless a source knows it better.
require "KnowledgeSource";

Blackboard = {};
Blackboard.__index = Blackboard;

function Blackboard.new(userData)
    return setmetatable({ userData_ = userData, values_ = {}, sources_ = {} }, Blackboard);
end

-- The answer of the most confident source; what was set, if there is no source.
function Blackboard:Get(attribute)
    local best, highest;
    for _, source in ipairs(self.sources_[attribute] or {}) do
        local evaluation, confidence = source:Evaluate(self.userData_);
        if (not highest or confidence > highest) then
            best, highest = evaluation, confidence;
        end
    end
    if (highest) then
        return best;
    end
    return self.values_[attribute];
end

function Blackboard:Set(attribute, value)
    self.values_[attribute] = value;
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
