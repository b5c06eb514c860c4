-- SPDX-License-Identifier: BSD-2-Clause
-- A named function of the user data that returns a result.

Evaluator = {};
Evaluator.__index = Evaluator;
Evaluator.__call = function(self, ...)
    return self.evaluate_(...);
end

function Evaluator.new(name, evaluate, userData)
    return setmetatable({ name_ = name or "", evaluate_ = evaluate, userData_ = userData }, Evaluator);
end

function Evaluator:GetName()
    return self.name_;
end

function Evaluator:Evaluate(userData)
    if (userData == nil) then
        userData = self.userData_;
    end
    return self.evaluate_(userData);
end
