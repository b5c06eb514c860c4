-- SPDX-License-Identifier: BSD-2-Clause
-- Searches an action, starting at the root: a selector takes its first child that succeeds; a sequence continues as
-- long as its children succeed; a condition succeeds if its evaluator returns true; an action always succeeds. The
-- action runs to its end. Then the sequence that contains it continues, or the search starts again at the root.
require "Action";
require "BehaviorTreeNode";

BehaviorTree = {};
BehaviorTree.__index = BehaviorTree;

function BehaviorTree.new(userData)
    return setmetatable({ userData_ = userData }, BehaviorTree);
end

function BehaviorTree:SetNode(node)
    self.root_ = node;
end

function BehaviorTree:GetCurrentNode()
    return self.current_;
end

function BehaviorTree:GetCurrentActionName()
    return self.current_ and self.current_:GetAction():GetName() or nil;
end

-- What users see of the tree: each node with the result of its last evaluation, and the path to the running action.
local function Rows(tree, node)
    local answer = node.answer_;
    local row = { name = node.name_, value = "" };
    if (node.name_ == "") then
        row.name = node.action_ and node.action_:GetName() or string.lower(node.type_);
    end
    if (answer ~= nil) then
        row.value = answer and "yes" or "no";
    end
    local step = tree.current_;
    while (step) do
        row.active = row.active or step == node;
        step = step.parent_;
    end
    for _, child in ipairs(node.children_) do
        table.insert(row, Rows(tree, child));
    end
    return row;
end

local Walk;

-- Evaluates the children from `first` on. Returns the node of the action to run, if any, and whether the node succeeds.
local function WalkChildren(tree, node, first)
    local is_selector = node.type_ == BehaviorTreeNode.Type.SELECTOR;
    for index = first, #node.children_ do
        local action, works = Walk(tree, node.children_[index]);
        if (action or works == is_selector) then
            return action, works;
        end
    end
    return nil, not is_selector;
end

Walk = function(tree, node)
    if (node.type_ == BehaviorTreeNode.Type.ACTION) then
        return node, true;
    elseif (node.type_ == BehaviorTreeNode.Type.CONDITION) then
        node.answer_ = not not node.evaluator_(tree.userData_);
        return nil, node.answer_;
    end
    return WalkChildren(tree, node, 1);
end

-- The action after one that has ended: the next action of the sequences that contain it, if they continue.
local function Next(tree, node)
    while (node.parent_) do
        if (node.parent_.type_ == BehaviorTreeNode.Type.SEQUENCE) then
            local action, works = WalkChildren(tree, node.parent_, node.index_ + 1);
            if (action or not works) then
                return action;
            end
        end
        node = node.parent_;
    end
end

local function ShowTree(tree)
    local agent = Agent.Self();
    if (agent) then
        agent:Show("behavior tree", { Rows(tree, tree.root_) });
    end
end

-- One step: a decision and the start of its action, or a step of the action, or its clean-up.
function BehaviorTree:Update(deltaTimeInMillis)
    if (not self.root_) then
        return;
    end
    local current = self.current_;
    if (not current) then
        self.current_ = Walk(self, self.root_);
        ShowTree(self);
        if (self.current_) then
            self.current_:GetAction():Initialize();
        end
    elseif (current:GetAction():IsTerminated()) then
        current:GetAction():CleanUp();
        self.current_ = Next(self, current);
        ShowTree(self);
        if (self.current_) then
            self.current_:GetAction():Initialize();
        end
    else
        current:GetAction():Update(deltaTimeInMillis);
    end
end
