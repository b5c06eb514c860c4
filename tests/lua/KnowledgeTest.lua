-- SPDX-License-Identifier: BSD-2-Clause
-- Blackboards and knowledge sources.
require "Check";
require "Blackboard";

local tests = {};

local function Source(confidence, evaluation, period)
    return KnowledgeSource.new(function() return { confidence = confidence, evaluation = evaluation }; end, period);
end

function tests.ABlackboardKeepsWhatItIsTold()
    local board = Blackboard.new({});
    CheckEqual(nil, board:Get("enemy"));
    board:Set("enemy", "wolf");
    CheckEqual("wolf", board:Get("enemy"));
end

function tests.TheMostConfidentSourceWinsOverWhatWasSet()
    local board = Blackboard.new({});
    local unsure, sure = Source(0.2, "bear"), Source(0.9, "fox");
    board:Set("enemy", "wolf");
    board:AddSource("enemy", unsure);
    CheckEqual("bear", board:Get("enemy"));
    board:AddSource("enemy", sure);
    CheckEqual("fox", board:Get("enemy"));
    board:RemoveSource("enemy", sure);
    CheckEqual("bear", board:Get("enemy"));
    board:RemoveSource("enemy", unsure);
    CheckEqual("wolf", board:Get("enemy"));
    board:RemoveSource("unheard", unsure);
end

function tests.ASourceMayKnowThatThereIsNothing()
    local board = Blackboard.new({});
    board:Set("enemy", "wolf");
    board:AddSource("enemy", Source(1, nil));
    CheckEqual(nil, board:Get("enemy"));
end

function tests.ASourceSeesTheUserDataAndRestsForItsPeriod()
    local asked = 0;
    local source = KnowledgeSource.new(function(data)
        asked = asked + 1;
        return { confidence = 1, evaluation = data.agent:GetId() };
    end, 1000);
    local board = Blackboard.new({ agent = agent });
    board:AddSource("self", source);
    CheckEqual(agent:GetId(), board:Get("self"));
    board:Get("self");
    CheckEqual(1, asked);
    local restless = KnowledgeSource.new(function() asked = asked + 1; return { confidence = 1 }; end);
    restless:Evaluate({ agent = agent });
    restless:Evaluate({ agent = agent });
    CheckEqual(3, asked);
end

RunTests(tests);
