-- SPDX-License-Identifier: BSD-2-Clause
-- Decides what to do, does it to its end, and decides again.
require "Action";
require "DecisionBranch";

DecisionTree = {};
DecisionTree.__index = DecisionTree;

function DecisionTree.new(userData)
    return setmetatable({ userData_ = userData }, DecisionTree);
end

function DecisionTree:SetBranch(branch)
    self.branch_ = branch;
end

function DecisionTree:GetCurrentAction()
    return self.action_;
end

function DecisionTree:GetCurrentActionName()
    return self.action_ and self.action_:GetName() or nil;
end

-- One step: a decision and the start of its action, or a step of the action, or its clean-up.
function DecisionTree:Update(deltaTimeInMillis)
    if (not self.branch_) then
        return;
    end
    if (not self.action_) then
        self.action_ = self.branch_:Evaluate(self.userData_);
        self.action_:Initialize();
    elseif (self.action_:IsTerminated()) then
        self.action_:CleanUp();
        self.action_ = nil;
    else
        self.action_:Update(deltaTimeInMillis);
    end
end
