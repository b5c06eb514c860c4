-- SPDX-License-Identifier: BSD-2-Clause
-- A node of a behavior tree.

BehaviorTreeNode = {
    Type = { ACTION = "ACTION", CONDITION = "CONDITION", SELECTOR = "SELECTOR", SEQUENCE = "SEQUENCE" }
};
BehaviorTreeNode.__index = BehaviorTreeNode;

-- SELECTOR and SEQUENCE have children; ACTION has an action; CONDITION has an evaluator(userData) that says yes or no.
function BehaviorTreeNode.new(name, type)
    assert(BehaviorTreeNode.Type[type], "a behavior tree has no nodes of type " .. tostring(type));
    return setmetatable({ name_ = name or "", type_ = type, children_ = {} }, BehaviorTreeNode);
end

-- Returns the child.
function BehaviorTreeNode:AddChild(child)
    child.parent_ = self;
    child.index_ = #self.children_ + 1;
    self.children_[child.index_] = child;
    return child;
end

function BehaviorTreeNode:SetAction(action)
    self.action_ = action;
end

function BehaviorTreeNode:GetAction()
    return self.action_;
end

function BehaviorTreeNode:SetEvaluator(evaluator)
    self.evaluator_ = evaluator;
end

function BehaviorTreeNode:GetName()
    return self.name_;
end

function BehaviorTreeNode:GetType()
    return self.type_;
end

function BehaviorTreeNode:GetParent()
    return self.parent_;
end

function BehaviorTreeNode:GetChildren()
    return self.children_;
end

function BehaviorTreeNode:GetNumberOfChildren()
    return #self.children_;
end
