-- SPDX-License-Identifier: BSD-2-Clause
-- Selects an action, runs it to its end, and selects again.
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

-- What users see of the tree: each branch with the last choice of its evaluator, and the path to the running action.
local function Rows(node, isChosen)
    if (node.type_ ~= DecisionBranch.Type) then
        return { name = node:GetName(), active = isChosen };
    end
    local evaluator = node.evaluator_;
    local row = { name = "branch", active = isChosen };
    if (type(evaluator) == "table" and evaluator.GetName) then
        row.name = evaluator:GetName();
    end
    if (isChosen) then
        row.value = node.answer_;
    end
    for place, child in ipairs(node.children_) do
        table.insert(row, Rows(child, isChosen and place == node.choice_));
    end
    return row;
end

local function ShowTree(tree)
    local agent = Agent.Self();
    if (agent) then
        agent:Show("decision tree", { Rows(tree.branch_, true) });
    end
end

-- One step: a decision and the start of its action, or a step of the action, or its clean-up.
function DecisionTree:Update(deltaTimeInMillis)
    if (not self.branch_) then
        return;
    end
    if (not self.action_) then
        self.action_ = self.branch_:Evaluate(self.userData_);
        ShowTree(self);
        self.action_:Initialize();
    elseif (self.action_:IsTerminated()) then
        self.action_:CleanUp();
        self.action_ = nil;
    else
        self.action_:Update(deltaTimeInMillis);
    end
end
