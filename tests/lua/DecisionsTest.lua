-- SPDX-License-Identifier: BSD-2-Clause
-- Actions, decision trees, state machines and behavior trees.
require "Check";
require "Evaluator";
require "DecisionTree";
require "FiniteStateMachine";
require "BehaviorTree";

-- An action that records its calls in userData.log and ends after some updates.
local function Noted(userData, name, updates)
    local left;
    return Action.new(name,
        function(data) left = updates; data.log = data.log .. "+" .. name; end,
        function(delta, data)
            left = left - 1;
            return left > 0 and Action.Status.RUNNING or Action.Status.TERMINATED;
        end,
        function(data) data.log = data.log .. "-" .. name; end,
        userData);
end

local function Steps(runner, count)
    for _ = 1, count do
        runner:Update(33);
    end
end

local tests = {};

function tests.AnActionIsCleanedUpOnlyAfterItsEnd()
    local data = { log = "" };
    local action = Noted(data, "a", 2);
    CheckEqual(Action.Status.UNINITIALIZED, action:GetStatus());
    action:Initialize();
    action:Initialize();
    action:CleanUp();
    CheckEqual("+a", data.log);
    CheckEqual(Action.Status.RUNNING, action:Update(33));
    CheckEqual(Action.Status.TERMINATED, action:Update(33));
    CheckEqual(Action.Status.TERMINATED, action:Update(33));
    action:CleanUp();
    CheckEqual("+a-a", data.log);
    CheckEqual(Action.Status.UNINITIALIZED, action:GetStatus());
end

function tests.AnActionWithoutFunctionsEndsAtOnce()
    local action = Action.new("nothing");
    action:Initialize();
    Check(action:Update(33) == Action.Status.TERMINATED and action:IsTerminated());
    CheckEqual("nothing", action:GetName());
end

function tests.AnActionWhoseUpdateReturnsNoStatusIsAnError()
    local action = Action.new("odd", nil, function() return 5; end);
    action:Initialize();
    local ok, message = pcall(action.Update, action, 33);
    Check(not ok and string.find(message, "'odd' returned no status", 1, true), message);
end

function tests.EvaluatorsAskTheirFunction()
    local evaluator = Evaluator.new("big", function(data) return data > 3; end, 5);
    CheckEqual("big", evaluator:GetName());
    CheckEqual(true, evaluator:Evaluate());
    CheckEqual(false, evaluator:Evaluate(2));
    CheckEqual(true, evaluator(4));
end

function tests.ADecisionTreeRunsTheChosenActionToItsEnd()
    local data = { log = "", choice = 2 };
    local tree, outer, inner = DecisionTree.new(data), DecisionBranch.new(), DecisionBranch.new();
    outer:SetEvaluator(function(d) return d.choice == 1; end);
    outer:AddChild(Noted(data, "a", 1));
    outer:AddChild(inner);
    inner:SetEvaluator(function(d) return d.choice - 1; end);
    inner:AddChild(Noted(data, "b", 2));
    inner:AddChild(Noted(data, "c", 1));
    tree:SetBranch(outer);
    tree:Update(33);
    CheckEqual("b", tree:GetCurrentActionName());
    data.choice = 1;
    Steps(tree, 2);
    CheckEqual("+b", data.log);
    Steps(tree, 2);
    CheckEqual("+b-b+a", data.log);
    data.choice = 3;
    Steps(tree, 3);
    CheckEqual("+b-b+a-a+c", data.log);
end

function tests.AStateMachineTakesTheFirstOpenTransition()
    local data = { log = "" };
    local machine = FiniteStateMachine.new(data);
    machine:AddState("idle", Noted(data, "idle", 1));
    machine:AddState("move", Noted(data, "move", 1));
    machine:AddState("flee", Noted(data, "flee", 1));
    Check(not machine:AddTransition("idle", "fly", function() return true; end));
    machine:AddTransition("idle", "flee", function(d) return d.afraid; end);
    machine:AddTransition("idle", "move", function(d) return d.bored; end);
    Check(machine:ContainsTransition("idle", "move") and not machine:ContainsTransition("move", "idle"));
    machine:SetState("idle");
    Steps(machine, 2);
    CheckEqual("+idle-idle+idle", data.log);
    data.bored, data.afraid = true, true;
    Steps(machine, 2);
    CheckEqual("flee", machine:GetCurrentStateName());
    Steps(machine, 2);
    CheckEqual("flee", machine:GetCurrentStateName());
    Check(not pcall(machine.SetState, machine, "fly"));
end

local function Node(kind, name, children)
    local node = BehaviorTreeNode.new(name, kind);
    for _, child in ipairs(children or {}) do
        node:AddChild(child);
    end
    return node;
end

local function ActionNode(data, name, updates)
    local node = Node("ACTION", name);
    node:SetAction(Noted(data, name, updates or 1));
    return node;
end

local function ConditionNode(name)
    local node = Node("CONDITION", name);
    node:SetEvaluator(function(data) return data[name]; end);
    return node;
end

function tests.ABehaviorTreeFallsBackToTheNextChildOfASelector()
    local data = { log = "" };
    local tree = BehaviorTree.new(data);
    tree:SetNode(Node("SELECTOR", "root", {
        Node("SEQUENCE", "shooting", { ConditionNode("armed"), ActionNode(data, "shoot") }),
        ActionNode(data, "idle")
    }));
    Steps(tree, 3);
    CheckEqual("+idle-idle", data.log);
    data.armed = true;
    Steps(tree, 1);
    CheckEqual("shoot", tree:GetCurrentActionName());
    CheckEqual("shooting", tree:GetCurrentNode():GetParent():GetName());
end

function tests.ASequenceGoesOnAfterAnActionUntilACondition()
    local data = { log = "", armed = true };
    local tree = BehaviorTree.new(data);
    tree:SetNode(Node("SELECTOR", "root", {
        Node("SEQUENCE", "attack", {
            ConditionNode("armed"), ActionNode(data, "aim"), ActionNode(data, "shoot"), ConditionNode("loud"),
            ActionNode(data, "shout")
        }),
        ActionNode(data, "idle")
    }));
    Steps(tree, 5);
    CheckEqual("+aim-aim+shoot-shoot", data.log);
    data.armed = false;
    Steps(tree, 1);
    CheckEqual("idle", tree:GetCurrentActionName());
    data.armed, data.loud = true, true;
    Steps(tree, 8);
    CheckEqual("+aim-aim+shoot-shoot+idle-idle+aim-aim+shoot-shoot+shout", data.log);
end

function tests.ABehaviorTreeWithoutAWorkingNodeDoesNothing()
    local tree = BehaviorTree.new({});
    tree:SetNode(Node("SEQUENCE", "root", { ConditionNode("never"), ActionNode({ log = "" }, "a") }));
    Steps(tree, 3);
    CheckEqual(nil, tree:GetCurrentNode());
    Check(not pcall(BehaviorTreeNode.new, "x", "CIRCLE"));
end

RunTests(tests);
