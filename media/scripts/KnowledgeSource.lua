-- SPDX-License-Identifier: BSD-2-Clause
-- Determines a value, and the confidence in it.
KnowledgeSource = {};
KnowledgeSource.__index = KnowledgeSource;

-- evaluator(userData) returns {confidence = 0 to 1, evaluation = the value}. It is called again only after
-- updateFrequency milliseconds of simulated time; with 0, or without an agent in userData, at each request.
function KnowledgeSource.new(evaluator, updateFrequency)
    return setmetatable({ evaluator_ = evaluator, period_ = updateFrequency or 0 }, KnowledgeSource);
end

-- Returns the evaluation and the confidence.
function KnowledgeSource:Evaluate(userData)
    local now;
    if (self.period_ > 0 and userData and userData.agent) then
        now = Sandbox.GetTimeInMillis(userData.agent:GetSandbox());
    end
    local is_fresh = now and self.time_ and now < self.time_ + self.period_;
    if (not is_fresh) then
        local answer = self.evaluator_(userData) or {};
        self.evaluation_ = answer.evaluation;
        self.confidence_ = answer.confidence or 0;
        self.time_ = now;
    end
    return self.evaluation_, self.confidence_;
end
