-- SPDX-License-Identifier: BSD-2-Clause
-- Runs the action of its state to the end, then takes the first open transition of the state; if none is open, the
-- action starts again.
require "Action";
require "FiniteState";
require "FiniteStateTransition";

FiniteStateMachine = {};
FiniteStateMachine.__index = FiniteStateMachine;

function FiniteStateMachine.new(userData)
    return setmetatable({ userData_ = userData, states_ = {}, transitions_ = {} }, FiniteStateMachine);
end

function FiniteStateMachine:AddState(name, action)
    self.states_[name] = FiniteState.new(name, action);
    self.transitions_[name] = {};
end

-- evaluator(userData) returns whether the transition is open. Transitions are tried in the order in which they were
-- added. Both states must exist.
function FiniteStateMachine:AddTransition(fromStateName, toStateName, evaluator)
    if (not self:ContainsState(fromStateName) or not self:ContainsState(toStateName)) then
        return false;
    end
    table.insert(self.transitions_[fromStateName], FiniteStateTransition.new(toStateName, evaluator));
    return true;
end

function FiniteStateMachine:ContainsState(name)
    return self.states_[name] ~= nil;
end

function FiniteStateMachine:ContainsTransition(fromStateName, toStateName)
    for _, transition in ipairs(self.transitions_[fromStateName] or {}) do
        if (transition.toStateName_ == toStateName) then
            return true;
        end
    end
    return false;
end

function FiniteStateMachine:GetCurrentStateName()
    return self.state_ and self.state_.name_ or nil;
end

-- The status of the state's action; nil if there is none.
function FiniteStateMachine:GetCurrentStateStatus()
    local action = self.state_ and self.state_.action_;
    return action and action:GetStatus() or nil;
end

-- What users see of the machine: its states by name, the current one, and the last results of the conditions of its
-- transitions.
local function ShowMachine(machine)
    local agent = Agent.Self();
    if (not agent) then
        return;
    end
    local rows = {};
    for name, state in pairs(machine.states_) do
        local row = { name = name, active = state == machine.state_ };
        for _, transition in ipairs(machine.transitions_[name]) do
            local value = "";
            if (transition.answer_ ~= nil) then
                value = transition.answer_ and "yes" or "no";
            end
            table.insert(row, { name = "to " .. transition.toStateName_, value = value });
        end
        table.insert(rows, row);
    end
    agent:Show("state machine", rows);
end

-- Enters a state immediately; a running action is dropped without clean-up.
function FiniteStateMachine:SetState(name)
    assert(self:ContainsState(name), "the state machine has no state '" .. tostring(name) .. "'");
    self.state_ = self.states_[name];
    ShowMachine(self);
    if (self.state_.action_) then
        self.state_.action_:Initialize();
    end
end

local function OpenTransition(machine)
    for _, transition in ipairs(machine.transitions_[machine.state_.name_]) do
        transition.answer_ = not not transition.evaluator_(machine.userData_);
        if (transition.answer_) then
            return transition;
        end
    end
end

function FiniteStateMachine:Update(deltaTimeInMillis)
    if (not self.state_) then
        return;
    end
    local action = self.state_.action_;
    if (action and not action:IsTerminated()) then
        action:Update(deltaTimeInMillis);
        return;
    end
    if (action) then
        action:CleanUp();
    end
    local transition = OpenTransition(self);
    self:SetState(transition and transition.toStateName_ or self.state_.name_);
end
