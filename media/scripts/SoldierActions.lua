-- SPDX-License-Identifier: BSD-2-Clause
-- The actions of a soldier. userData contains agent, controller and blackboard (enemy, ammo, maxAmmo, alive,
-- bestFleePosition).
require "Action";
require "AgentCommunications";
require "DebugUtilities";
require "SoldierController";

local Commands = SoldierController.Commands;
local kMesh = "default";
local kReached = 1.5;
local kPursueRange = 3;
local kIdleMillis = 2000;
local kMoveMillis = 500;
local kLift = Vector.new(0, 0.1, 0);

-- The clean-up of actions without lasting effects.
local function LeaveAsItIs()
end

SoldierActions_ChangeStanceCleanUp = LeaveAsItIs;
SoldierActions_DieCleanUp = LeaveAsItIs;
SoldierActions_IdleCleanUp = LeaveAsItIs;
SoldierActions_MoveToCleanUp = LeaveAsItIs;
SoldierActions_RandomMoveCleanUp = LeaveAsItIs;
SoldierActions_ReloadCleanUp = LeaveAsItIs;
SoldierActions_ShootCleanUp = LeaveAsItIs;

local running, terminated = Action.Status.RUNNING, Action.Status.TERMINATED;

local function Now(userData)
    return Sandbox.GetTimeInMillis(userData.agent:GetSandbox());
end

local function Distance(userData, place)
    return Vector.Distance(userData.agent:GetPosition(), place);
end

-- Starts to move to a place; false if there is no path.
local function SetOff(userData, place)
    local agent = userData.agent;
    local path = Sandbox.FindPath(agent:GetSandbox(), kMesh, agent:GetPosition(), place);
    if (#path == 0) then
        return false;
    end
    Soldier_SetPath(agent, path, false);
    agent:SetTarget(path[#path]);
    return true;
end

local function Tell(userData, type, message)
    AgentCommunications_SendTeamMessage(userData.agent:GetSandbox(), userData.agent, type, message);
end

local function DrawWay(userData, color, radius)
    DebugUtilities_DrawPath(userData.agent:GetPath(), false, kLift, color);
    Core.DrawCircle(userData.agent:GetTarget() + kLift, radius, color);
end

-- A command that ends at once.
local function Once(command)
    return function(userData)
        userData.controller:QueueCommand(userData.agent, command);
    end;
end

-- Changes the stance.
SoldierActions_ChangeStanceInitialize = Once(Commands.CHANGE_STANCE);

function SoldierActions_ChangeStanceUpdate(deltaTimeInMillis, userData)
    return terminated;
end

-- Dies: no other action follows.
function SoldierActions_DieInitialize(userData)
    userData.controller:ImmediateCommand(userData.agent, Commands.DIE);
    Tell(userData, AgentCommunications.EventType.AgentDeath, { position = userData.agent:GetPosition() });
end

function SoldierActions_DieUpdate(deltaTimeInMillis, userData)
    userData.blackboard:Set("alive", false);
    return running;
end

-- Runs to the safest place in the blackboard.
function SoldierActions_FleeInitialize(userData)
    local place = userData.blackboard:Get("bestFleePosition");
    if (place and SetOff(userData, place)) then
        userData.controller:QueueCommand(userData.agent, Commands.MOVE);
        Tell(userData, AgentCommunications.EventType.RetreatPosition, { position = place });
    end
end

function SoldierActions_FleeUpdate(deltaTimeInMillis, userData)
    DrawWay(userData, DebugUtilities.Blue, kReached);
    if (userData.agent:GetHealth() <= 0 or not userData.agent:HasPath()) then
        return terminated;
    end
    return Distance(userData, userData.agent:GetTarget()) < kReached and terminated or running;
end

function SoldierActions_FleeCleanUp(userData)
    userData.agent:RemovePath();
end

-- Stands idle for some time.
function SoldierActions_IdleInitialize(userData)
    userData.controller:QueueCommand(userData.agent, Commands.IDLE);
    userData.idleEnd = Now(userData) + kIdleMillis;
end

function SoldierActions_IdleUpdate(deltaTimeInMillis, userData)
    return Now(userData) >= userData.idleEnd and terminated or running;
end

-- Continues along its path for some time.
function SoldierActions_MoveToInitialize(userData)
    userData.controller:QueueCommand(userData.agent, Commands.MOVE);
    userData.moveEnd = Now(userData) + kMoveMillis;
end

function SoldierActions_MoveToUpdate(deltaTimeInMillis, userData)
    DrawWay(userData, DebugUtilities.Orange, kReached);
    if (Distance(userData, userData.agent:GetTarget()) < kReached) then
        userData.agent:RemovePath();
        return terminated;
    end
    return Now(userData) >= userData.moveEnd and terminated or running;
end

-- Pursues its enemy until it is near.
function SoldierActions_PursueInitialize(userData)
    local enemy = userData.blackboard:Get("enemy");
    userData.pursued = enemy;
    if (enemy and SetOff(userData, enemy:GetPosition())) then
        userData.controller:QueueCommand(userData.agent, Commands.MOVE);
        Tell(userData, AgentCommunications.EventType.EnemySelection, { enemy = enemy });
    end
end

function SoldierActions_PursueUpdate(deltaTimeInMillis, userData)
    local enemy = userData.pursued;
    if (userData.agent:GetHealth() <= 0 or not enemy or enemy:GetHealth() <= 0) then
        return terminated;
    end
    if (Distance(userData, enemy:GetPosition()) < kPursueRange or not SetOff(userData, enemy:GetPosition())) then
        return terminated;
    end
    DrawWay(userData, DebugUtilities.Red, kPursueRange);
    return running;
end

function SoldierActions_PursueCleanUp(userData)
    userData.agent:RemovePath();
    userData.pursued = nil;
    Tell(userData, AgentCommunications.EventType.PositionUpdate, { position = userData.agent:GetPosition() });
end

-- Chooses a place to go to; MoveTo does the movement.
function SoldierActions_RandomMoveInitialize(userData)
    local place = Soldier_PathToRandomPoint(userData.agent);
    if (place) then
        SetOff(userData, place);
    end
end

function SoldierActions_RandomMoveUpdate(deltaTimeInMillis, userData)
    return terminated;
end

-- Fills the magazine.
function SoldierActions_ReloadInitialize(userData)
    userData.controller:QueueCommand(userData.agent, Commands.IDLE);
end

function SoldierActions_ReloadUpdate(deltaTimeInMillis, userData)
    if (userData.controller:QueueLength() > 0) then
        return running;
    end
    userData.blackboard:Set("ammo", userData.blackboard:Get("maxAmmo"));
    return terminated;
end

-- Turns to its enemy and shoots once or twice.
function SoldierActions_ShootInitialize(userData)
    userData.controller:QueueCommand(userData.agent, Commands.SHOOT);
    userData.controller:QueueCommand(userData.agent, Commands.IDLE);
end

function SoldierActions_ShootUpdate(deltaTimeInMillis, userData)
    local enemy = userData.blackboard:Get("enemy");
    if (enemy) then
        userData.agent:SetForward(enemy:GetPosition() - userData.agent:GetPosition());
    end
    if (userData.controller:QueueLength() > 0) then
        return running;
    end
    userData.blackboard:Set("ammo", (userData.blackboard:Get("ammo") or 1) - 1);
    return terminated;
end
