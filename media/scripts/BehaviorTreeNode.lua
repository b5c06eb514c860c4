-- SPDX-License-Identifier: BSD-2-Clause
-- A node of a behavior tree.

BehaviorTreeNode = {
    Type = { ACTION = "ACTION", CONDITION = "CONDITION", SELECTOR = "SELECTOR", SEQUENCE = "SEQUENCE" }
};
BehaviorTreeNode.__index = BehaviorTreeNode;

-- SELECTOR and SEQUENCE have children; ACTION has an action; CONDITION has an evaluator(userData) that returns true or
-- false.
function BehaviorTreeNode.new(name, type)
    assert(BehaviorTreeNode.Type[type], "a behavior tree has no nodes of type " .. tostring(type));
    return setmetatable({ name_ = name or "", type_ = type, children_ = {} }, BehaviorTreeNode);
end

-- Appends a child, or inserts it at `index`. Returns the child.
function BehaviorTreeNode:AddChild(child, index)
    child.parent_ = self;
    table.insert(self.children_, index or #self.children_ + 1, child);
    for place, sibling in ipairs(self.children_) do
        sibling.index_ = place;
    end
    return child;
end

-- The index of a child, from 1; -1 if it is not a child.
function BehaviorTreeNode:ChildIndex(child)
    for place, sibling in ipairs(self.children_) do
        if (sibling == child) then
            return place;
        end
    end
    return -1;
end

function BehaviorTreeNode:GetChild(index)
    return self.children_[index];
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

function BehaviorTreeNode:SetType(type)
    assert(BehaviorTreeNode.Type[type], "a behavior tree has no nodes of type " .. tostring(type));
    self.type_ = type;
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
