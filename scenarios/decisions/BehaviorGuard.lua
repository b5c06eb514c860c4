-- SPDX-License-Identifier: BSD-2-Clause
-- A guard with a behavior tree as its mind: it runs the first child of the selector that succeeds.
require "BehaviorTree";
require "GuardBody";

local guard, tree;

local function If(evaluator, action)
    local sequence = BehaviorTreeNode.new(action:GetName(), BehaviorTreeNode.Type.SEQUENCE);
    local condition = BehaviorTreeNode.new("if", BehaviorTreeNode.Type.CONDITION);
    local doing = BehaviorTreeNode.new(action:GetName(), BehaviorTreeNode.Type.ACTION);
    condition:SetEvaluator(evaluator);
    doing:SetAction(action);
    sequence:AddChild(condition);
    sequence:AddChild(doing);
    return sequence;
end

function Agent_Initialize(agent)
    guard = GuardBody_Create(agent);
    local patrol, chase, rest = GuardBody_Actions(guard);
    local root = BehaviorTreeNode.new("guard", BehaviorTreeNode.Type.SELECTOR);
    root:AddChild(If(GuardBody_IsTired, rest));
    root:AddChild(If(GuardBody_SeesIntruder, chase));
    root:AddChild(If(function() return true; end, patrol));
    tree = BehaviorTree.new(guard);
    tree:SetNode(root);
end

function Agent_Update(agent, deltaTimeInMillis)
    tree:Update(deltaTimeInMillis);
    GuardBody_Update(guard, deltaTimeInMillis);
end
