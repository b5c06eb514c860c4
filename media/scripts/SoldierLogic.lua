-- SPDX-License-Identifier: BSD-2-Clause
-- The mind of a soldier in three forms: a decision tree, a state machine and a behavior tree. All of them die, flee,
-- reload, shoot, pursue, move, search a place to go to, and idle, in this order of priority.
require "Action";
require "BehaviorTree";
require "DecisionBranch";
require "DecisionTree";
require "FiniteStateMachine";
require "SoldierActions";
require "SoldierEvaluators";

-- By name: the name of the action in SoldierActions. A scenario may replace SoldierActions, SoldierEvaluators and the
-- scripts that run actions, so only their common functions are used here.
local kActions = {
    die = "Die", flee = "Flee", idle = "Idle", move = "MoveTo", pursue = "Pursue", randomMove = "RandomMove",
    reload = "Reload", shoot = "Shoot"
};

local function Actions(userData)
    local actions = {};
    for name, action in pairs(kActions) do
        local prefix = "SoldierActions_" .. action;
        actions[name] = Action.new(
            name, _G[prefix .. "Initialize"], _G[prefix .. "Update"], _G[prefix .. "CleanUp"], userData);
    end
    return actions;
end

function SoldierLogic_DecisionTree(userData)
    local actions = Actions(userData);
    local function Branch(evaluator, yes, no)
        local branch = DecisionBranch.new();
        branch:SetEvaluator(function() return evaluator(userData) and 1 or 2; end);
        branch:AddChild(yes);
        branch:AddChild(no);
        return branch;
    end
    local wander = Branch(SoldierEvaluators_Random, actions.randomMove, actions.idle);
    local walk = Branch(SoldierEvaluators_HasMovePosition, actions.move, wander);
    local attack = Branch(SoldierEvaluators_CanShootAgent, actions.shoot, actions.pursue);
    local fight = Branch(SoldierEvaluators_HasAmmo, attack, actions.reload);
    local peace = Branch(SoldierEvaluators_HasEnemy, fight, walk);
    local retreat = Branch(SoldierEvaluators_HasMovePosition, actions.move, actions.flee);
    local live = Branch(SoldierEvaluators_HasCriticalHealth, retreat, peace);
    local tree = DecisionTree.new(userData);
    tree:SetBranch(Branch(SoldierEvaluators_IsAlive, live, actions.die));
    return tree;
end

local function Both(first, second)
    return function(userData)
        return first(userData) and second(userData);
    end;
end

-- In the order in which they are tried, from every state except death.
local kWays = {
    { "die", SoldierEvaluators_IsNotAlive },
    { "flee", SoldierEvaluators_HasCriticalHealth },
    { "reload", Both(SoldierEvaluators_HasEnemy, SoldierEvaluators_HasNoAmmo) },
    { "shoot", SoldierEvaluators_CanShootAgent },
    { "pursue", SoldierEvaluators_HasEnemy },
    { "move", SoldierEvaluators_HasMovePosition },
    { "randomMove", SoldierEvaluators_Random },
    { "idle", SoldierEvaluators_True }
};

function SoldierLogic_FiniteStateMachine(userData)
    local machine = FiniteStateMachine.new(userData);
    for name, action in pairs(Actions(userData)) do
        machine:AddState(name, action);
    end
    for _, from in ipairs(kWays) do
        for _, to in ipairs(kWays) do
            if (from[1] ~= "die") then
                machine:AddTransition(from[1], to[1], to[2]);
            end
        end
    end
    machine:SetState("idle");
    return machine;
end

local function ActionNode(name, actions)
    local node = BehaviorTreeNode.new(name, BehaviorTreeNode.Type.ACTION);
    node:SetAction(actions[name]);
    return node;
end

-- A child that succeeds only if the evaluator returns true.
local function If(name, evaluator, child)
    local sequence = BehaviorTreeNode.new(name, BehaviorTreeNode.Type.SEQUENCE);
    local condition = BehaviorTreeNode.new(name .. "?", BehaviorTreeNode.Type.CONDITION);
    condition:SetEvaluator(evaluator);
    sequence:AddChild(condition);
    sequence:AddChild(child);
    return sequence;
end

local function FirstOf(name, children)
    local selector = BehaviorTreeNode.new(name, BehaviorTreeNode.Type.SELECTOR);
    for _, child in ipairs(children) do
        selector:AddChild(child);
    end
    return selector;
end

function SoldierLogic_BehaviorTree(userData)
    local actions = Actions(userData);
    local tree = BehaviorTree.new(userData);
    tree:SetNode(FirstOf("soldier", {
        If("dead", SoldierEvaluators_IsNotAlive, ActionNode("die", actions)),
        If("hurt", SoldierEvaluators_HasCriticalHealth, ActionNode("flee", actions)),
        If("fight", SoldierEvaluators_HasEnemy, FirstOf("attack", {
            If("empty", SoldierEvaluators_HasNoAmmo, ActionNode("reload", actions)),
            If("near", SoldierEvaluators_CanShootAgent, ActionNode("shoot", actions)),
            ActionNode("pursue", actions)
        })),
        If("walk", SoldierEvaluators_HasMovePosition, ActionNode("move", actions)),
        If("wander", SoldierEvaluators_Random, ActionNode("randomMove", actions)),
        ActionNode("idle", actions)
    }));
    return tree;
end
