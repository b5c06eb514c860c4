-- SPDX-License-Identifier: BSD-2-Clause
-- An inner node of a decision tree: its evaluator selects the next child.

DecisionBranch = { Type = "DecisionBranch" };
DecisionBranch.__index = DecisionBranch;

function DecisionBranch.new(evaluator, userData)
    return setmetatable({
        children_ = {}, evaluator_ = evaluator, userData_ = userData, type_ = DecisionBranch.Type
    }, DecisionBranch);
end

-- Adds a child, which is an action or another branch, at the end or at `index`. Returns its number, from 1.
function DecisionBranch:AddChild(child, index)
    index = index or #self.children_ + 1;
    table.insert(self.children_, index, child);
    return index;
end

-- evaluator(userData) returns the number of a child; true counts as 1 and false as 2.
function DecisionBranch:SetEvaluator(evaluator, userData)
    self.evaluator_ = evaluator;
    if (userData ~= nil) then
        self.userData_ = userData;
    end
end

-- The action at the end of the branches that the evaluators select.
function DecisionBranch:Evaluate(userData)
    local data = self.userData_;
    if (data == nil) then
        data = userData;
    end
    local choice = self.evaluator_(data);
    self.answer_ = choice;
    if (choice == true) then
        choice = 1;
    elseif (choice == false or choice == nil) then
        choice = 2;
    end
    self.choice_ = choice;
    local child = self.children_[choice];
    assert(child, "a decision branch has no child number " .. tostring(choice));
    if (child.type_ == DecisionBranch.Type) then
        return child:Evaluate(data);
    end
    return child;
end
