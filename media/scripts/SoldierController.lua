-- SPDX-License-Identifier: BSD-2-Clause
-- Between mind and body: takes commands, one after the other, and moves a soldier's body as they say.
require "Soldier";

SoldierController = {
    Commands = {
        CHANGE_STANCE = "CHANGE_STANCE", DIE = "DIE", IDLE = "IDLE", MOVE = "MOVE", SHOOT = "SHOOT"
    }
};
SoldierController.__index = SoldierController;

local Commands = SoldierController.Commands;
local kFalling = "FALLING";
local kBrake = 0.5;

-- soldier and weapon are the meshes of Soldier_Create...; the weapon is hung into the soldier's hand.
function SoldierController.new(agent, soldier, weapon)
    local weaponStates = Soldier_CreateWeaponStateMachine(weapon);
    Soldier_AttachWeapon(soldier, weapon);
    local controller = setmetatable({
        soldier_ = soldier,
        stance_ = Soldier.Stance.STAND,
        states_ = Soldier_CreateSoldierStateMachine(soldier),
        weaponStates_ = weaponStates,
        accumulator_ = Vector.new(),
        queue_ = {}
    }, SoldierController);
    local function OnShot()
        Soldier_Shoot(agent:GetSandbox(), soldier);
    end
    controller.states_:AddStateCallback(Soldier.States.FIRE, OnShot);
    controller.states_:AddStateCallback(Soldier.States.CROUCH_FIRE, OnShot);
    controller:QueueCommand(agent, Commands.IDLE);
    return controller;
end

function SoldierController:QueueCommand(agent, command)
    table.insert(self.queue_, command);
end

-- Before all that waits.
function SoldierController:ImmediateCommand(agent, command)
    table.insert(self.queue_, 1, command);
end

function SoldierController:ClearCommands()
    self.queue_ = {};
end

-- What it does now; what it will do next if nothing is under way.
function SoldierController:CurrentCommand()
    return self.command_ or self.queue_[1];
end

function SoldierController:QueueLength()
    return #self.queue_;
end

function SoldierController:GetStance()
    return self.stance_;
end

local function IsStanding(controller)
    return controller.stance_ == Soldier.Stance.STAND;
end

-- Asks the animations for a state; true once it is there.
local function Reach(controller, state)
    if (controller.states_:GetCurrentStateName() == state) then
        return true;
    end
    controller.states_:RequestState(state);
    return false;
end

local function Finish(controller)
    controller.last_, controller.command_ = controller.command_, nil;
end

local function StandStill(controller, agent, state)
    Soldier_SlowMovement(agent, IsStanding(controller) and 1 or kBrake);
    if (Reach(controller, state) and #controller.queue_ > 0) then
        Finish(controller);
    end
end

local function Die(controller, agent, state)
    if (not Reach(controller, state)) then
        agent:RemovePhysics();
        agent:SetHealth(0);
    end
end

local execute = {
    [Commands.IDLE] = function(controller, agent)
        StandStill(controller, agent,
            IsStanding(controller) and Soldier.States.IDLE_AIM or Soldier.States.CROUCH_IDLE_AIM);
    end,
    [Commands.SHOOT] = function(controller, agent)
        StandStill(controller, agent, IsStanding(controller) and Soldier.States.FIRE or Soldier.States.CROUCH_FIRE);
    end,
    [Commands.MOVE] = function(controller, agent, deltaTimeInMillis)
        local stance = controller.stance_;
        if (not Reach(controller, IsStanding(controller) and Soldier.States.RUN_FORWARD or Soldier.States.CROUCH_FORWARD)) then
            agent:SetMaxSpeed(Soldier.Speed[stance]);
        elseif (#controller.queue_ > 0) then
            Finish(controller);
        end
        local force = Soldier_CalculateSteering(agent, stance);
        Soldier_ApplySteering(agent, force, controller.accumulator_, deltaTimeInMillis / 1000);
    end,
    [Commands.CHANGE_STANCE] = function(controller, agent)
        -- Afterwards it goes on with what it did before.
        if (#controller.queue_ == 0) then
            controller:QueueCommand(agent, controller.last_ or Commands.IDLE);
        end
        controller.stance_ = IsStanding(controller) and Soldier.Stance.CROUCH or Soldier.Stance.STAND;
        Soldier_SetStance(agent, controller.soldier_, controller.stance_);
        controller.command_ = nil;
    end,
    [Commands.DIE] = function(controller, agent)
        Soldier_SlowMovement(agent, kBrake);
        Die(controller, agent, IsStanding(controller) and Soldier.States.DEAD or Soldier.States.CROUCH_DEAD);
    end,
    [kFalling] = function(controller, agent)
        if (Soldier_IsFalling(agent)) then
            Reach(controller, Soldier.States.FALL_IDLE);
        else
            Die(controller, agent, Soldier.States.FALL_DEAD);
        end
    end
};

-- Once for each step of the agent.
function SoldierController:Update(agent, deltaTimeInMillis)
    local now = Sandbox.GetTimeInMillis(agent:GetSandbox());
    Soldier_UpdateImpacts(deltaTimeInMillis);
    self.states_:Update(deltaTimeInMillis, now);
    self.weaponStates_:Update(deltaTimeInMillis, now);

    local isFalling = self.command_ == kFalling;
    if (self.command_ ~= Commands.DIE and not isFalling and Soldier_IsFalling(agent)) then
        self.command_ = kFalling;
    end
    if (not self.command_) then
        self.command_ = table.remove(self.queue_, 1);
    end
    if (self.command_) then
        execute[self.command_](self, agent, deltaTimeInMillis);
    end
end
