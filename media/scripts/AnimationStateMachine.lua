-- SPDX-License-Identifier: BSD-2-Clause
-- Plays one animation at a time, and fades to another on request if the transition between the two permits it. A state
-- without a transition to it begins when the previous animation ends.
require "AnimationState";
require "AnimationTransition";
require "AnimationUtilities";

AnimationStateMachine = {};
AnimationStateMachine.__index = AnimationStateMachine;

function AnimationStateMachine.new()
    return setmetatable({ states_ = {}, transitions_ = {}, callbacks_ = {} }, AnimationStateMachine);
end

function AnimationStateMachine:AddState(name, animation, looping, rate)
    Animation.SetEnabled(animation, false);
    self.states_[name] = AnimationState.new(name, animation, looping, rate);
    self.transitions_[name] = {};
end

function AnimationStateMachine:AddTransition(fromName, toName, blendOutWindow, duration, blendInWindow)
    if (self:ContainsState(fromName) and self:ContainsState(toName)) then
        self.transitions_[fromName][toName] = AnimationTransition.new(blendOutWindow, duration, blendInWindow);
    end
end

-- callback(stateName, data) is called when a transition starts the state, and whenever its animation ends.
function AnimationStateMachine:AddStateCallback(name, callback, data)
    self.callbacks_[name] = self.callbacks_[name] or {};
    table.insert(self.callbacks_[name], { call = callback, data = data });
end

function AnimationStateMachine:ContainsState(name)
    return self.states_[name] ~= nil;
end

function AnimationStateMachine:ContainsTransition(fromName, toName)
    return self.transitions_[fromName] ~= nil and self.transitions_[fromName][toName] ~= nil;
end

function AnimationStateMachine:GetCurrentStateName()
    return self.current_ and self.current_.name_ or nil;
end

local function Notify(machine, state)
    for _, callback in ipairs(machine.callbacks_[state.name_] or {}) do
        callback.call(state.name_, callback.data);
    end
end

local function Play(state, weight, time)
    Animation.Reset(state.animation_);
    Animation.SetLooping(state.animation_, state.looping_);
    Animation.SetEnabled(state.animation_, true);
    Animation.SetWeight(state.animation_, weight);
    if (time > 0) then
        Animation.SetTime(state.animation_, time);
    end
end

local function Stop(state)
    Animation.SetEnabled(state.animation_, false);
    Animation.SetWeight(state.animation_, 0);
end

-- Advances the animation of a state; true if it has ended.
local function Step(state, deltaTimeInMillis)
    local delta = deltaTimeInMillis * state.rate_;
    local ends = Animation.GetTime(state.animation_) + delta / 1000 >= Animation.GetLength(state.animation_);
    Animation.StepAnimation(state.animation_, delta);
    return ends;
end

-- Changes to a state immediately.
function AnimationStateMachine:SetState(name)
    if (not self:ContainsState(name)) then
        return;
    end
    if (self.next_ and self.next_.animation_ ~= self.current_.animation_) then
        Stop(self.next_);
    end
    if (self.current_) then
        Stop(self.current_);
    end
    self.next_, self.requested_ = nil, nil;
    self.current_ = self.states_[name];
    Play(self.current_, 1, 0);
end

-- False while another request is pending, and for unknown states.
function AnimationStateMachine:RequestState(name)
    if (self.requested_ or self.next_ or not self:ContainsState(name)) then
        return false;
    end
    if (self.current_) then
        self.requested_ = self.states_[name];
    else
        self:SetState(name);
    end
    return true;
end

local function StartTransition(machine, transition, nowInSeconds)
    machine.next_, machine.requested_ = machine.requested_, nil;
    machine.transition_, machine.start_ = transition, nowInSeconds;
    -- States may share an animation: then no fade is needed.
    if (machine.next_.animation_ ~= machine.current_.animation_) then
        Play(machine.next_, 0, transition.blendInWindow_);
    end
    Notify(machine, machine.next_);
end

local function Fade(machine, deltaTimeInMillis, nowInSeconds)
    local from, to = machine.current_, machine.next_;
    local shares = from.animation_ == to.animation_;
    if (Step(to, deltaTimeInMillis)) then
        Notify(machine, to);
    end
    local is_over = nowInSeconds - machine.start_ >= machine.transition_.duration_;
    if (not shares) then
        Step(from, deltaTimeInMillis);
        is_over = AnimationUtilities_LinearBlendTo(
            from.animation_, to.animation_, machine.transition_.duration_, machine.start_, nowInSeconds);
    end
    if (is_over) then
        if (shares) then
            Animation.SetLooping(to.animation_, to.looping_);
            Animation.SetWeight(to.animation_, 1);
        else
            Stop(from);
        end
        machine.current_, machine.next_ = to, nil;
    end
end

function AnimationStateMachine:Update(deltaTimeInMillis, currentTimeInMillis)
    if (not self.current_) then
        return;
    end
    local now = currentTimeInMillis / 1000;
    if (self.next_) then
        Fade(self, deltaTimeInMillis, now);
        return;
    end
    if (self.requested_) then
        local transition = self.transitions_[self.current_.name_][self.requested_.name_];
        local animation = self.current_.animation_;
        local after = Animation.GetTime(animation) + deltaTimeInMillis / 1000 * self.current_.rate_;
        if (transition and after >= Animation.GetLength(animation) - transition.blendOutWindow_) then
            StartTransition(self, transition, now);
            Fade(self, deltaTimeInMillis, now);
            return;
        end
    end
    if (Step(self.current_, deltaTimeInMillis)) then
        Notify(self, self.current_);
        if (self.requested_) then
            self:SetState(self.requested_.name_);
        end
    end
end
