-- SPDX-License-Identifier: BSD-2-Clause
-- The layer between mind and body: accepts commands, and executes them with a soldier's body one after the other.
require "Soldier";

SoldierController = {
    Commands = {
        CHANGE_STANCE = "CHANGE_STANCE", DIE = "DIE", IDLE = "IDLE", MOVE = "MOVE", SHOOT = "SHOOT"
    },
    Stances = { CROUCH = "CROUCH", STAND = "STAND" }
};
SoldierController.__index = SoldierController;

local Commands, Stances, States = SoldierController.Commands, SoldierController.Stances, Soldier.SoldierStates;
local kFalling = "FALLING";
local kBrake = 2;

-- soldier and weapon are the meshes of Soldier_Create...; attach the weapon to the soldier's hand afterwards.
function SoldierController.new(agent, soldier, weapon)
    local controller = setmetatable({
        soldier_ = soldier,
        stance_ = Stances.STAND,
        states_ = Soldier_CreateSoldierStateMachine(soldier),
        weaponStates_ = Soldier_CreateWeaponStateMachine(weapon),
        queue_ = {}
    }, SoldierController);
    local data = { agent = agent, soldier = soldier };
    controller.states_:AddStateCallback(States.STAND_FIRE, Soldier_Shoot, data);
    controller.states_:AddStateCallback(States.CROUCH_FIRE, Soldier_Shoot, data);
    controller:QueueCommand(agent, Commands.IDLE);
    return controller;
end

function SoldierController:QueueCommand(agent, command)
    table.insert(self.queue_, command);
end

-- Before all queued commands.
function SoldierController:ImmediateCommand(agent, command)
    table.insert(self.queue_, 1, command);
end

function SoldierController:ClearCommands()
    self.queue_ = {};
end

-- The current command; the next one if none is running.
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
    return controller.stance_ == Stances.STAND;
end

-- Requests an animation state; true once it is reached.
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

local function SlowDown(agent, deltaTimeInMillis, rate)
    if (Soldier_IsMoving(agent)) then
        Soldier_SlowMovement(agent, deltaTimeInMillis, rate);
    end
end

local function StandStill(controller, agent, deltaTimeInMillis, state)
    SlowDown(agent, deltaTimeInMillis, IsStanding(controller) and 1 or kBrake);
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
    [Commands.IDLE] = function(controller, agent, deltaTimeInMillis)
        StandStill(controller, agent, deltaTimeInMillis,
            IsStanding(controller) and States.STAND_IDLE_AIM or States.CROUCH_IDLE_AIM);
    end,
    [Commands.SHOOT] = function(controller, agent, deltaTimeInMillis)
        StandStill(controller, agent, deltaTimeInMillis,
            IsStanding(controller) and States.STAND_FIRE or States.CROUCH_FIRE);
    end,
    [Commands.MOVE] = function(controller, agent, deltaTimeInMillis)
        local stands, deltaTimeInSeconds = IsStanding(controller), deltaTimeInMillis / 1000;
        if (not Reach(controller, stands and States.STAND_RUN_FORWARD or States.CROUCH_FORWARD)) then
            agent:SetMaxSpeed(stands and Soldier.Speed.Stand or Soldier.Speed.Crouch);
        elseif (#controller.queue_ > 0) then
            Finish(controller);
        end
        local steer = stands and Soldier_CalculateSteering or Soldier_CalculateSlowSteering;
        Soldier_ApplySteering(agent, steer(agent, deltaTimeInSeconds), deltaTimeInSeconds);
    end,
    [Commands.CHANGE_STANCE] = function(controller, agent)
        -- Afterwards the previous command continues.
        if (#controller.queue_ == 0) then
            controller:QueueCommand(agent, controller.last_ or Commands.IDLE);
        end
        local stands = not IsStanding(controller);
        controller.stance_ = stands and Stances.STAND or Stances.CROUCH;
        Soldier_SetHeight(agent, controller.soldier_, stands and Soldier.Height.Stand or Soldier.Height.Crouch);
        controller.command_ = nil;
    end,
    [Commands.DIE] = function(controller, agent, deltaTimeInMillis)
        SlowDown(agent, deltaTimeInMillis, kBrake);
        Die(controller, agent, IsStanding(controller) and States.STAND_DEAD or States.CROUCH_DEAD);
    end,
    [kFalling] = function(controller, agent)
        if (Soldier_IsFalling(agent)) then
            Reach(controller, States.STAND_FALL_IDLE);
        else
            Die(controller, agent, States.STAND_FALL_DEAD);
        end
    end
};

-- Call it once per step of the agent.
function SoldierController:Update(agent, deltaTimeInMillis)
    local now = Sandbox.GetTimeInMillis(agent:GetSandbox());
    Soldier_Update(agent, deltaTimeInMillis);
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
