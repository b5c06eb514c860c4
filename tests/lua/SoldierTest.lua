-- SPDX-License-Identifier: BSD-2-Clause
-- Soldiers: the names of their parts in scripts, and minds with parts that a scenario replaces.
require "Check";
require "AgentSenses";
require "IndirectSoldierAgent";
require "SoldierTactics";

local tests = {};

local function SoldierOf(owner)
    local soldier, weapon = Soldier_CreateSoldier(owner), Soldier_CreateWeapon(owner);
    local controller = SoldierController.new(owner, soldier, weapon);
    Soldier_AttachWeapon(soldier, weapon);
    return controller, soldier;
end

function tests.TheStatesHaveTheNamesThatScriptsUse()
    for name, value in pairs({
        STAND_IDLE_AIM = "idle_aim", STAND_FIRE = "fire", STAND_RUN_FORWARD = "run_forward", STAND_DEAD = "dead",
        STAND_FALL_IDLE = "fall_idle", STAND_FALL_DEAD = "fall_dead", STAND_RELOAD = "reload", STAND_MELEE = "melee",
        STAND_DEAD_HEADSHOT = "dead_headshot", STAND_JUMP_UP = "jump_up", CROUCH_IDLE_AIM = "crouch_idle_aim",
        CROUCH_FIRE = "crouch_fire", CROUCH_FORWARD = "crouch_forward", CROUCH_DEAD = "crouch_dead"
    }) do
        CheckEqual(value, Soldier.SoldierStates[name]);
    end
    CheckEqual("smg_idle", Soldier.WeaponStates.SMG_IDLE);
    CheckEqual("sniper_transform", Soldier.WeaponStates.SNIPER_TRANSFORM);
    CheckEqual("STAND", SoldierController.Stances.STAND);
end

function tests.EachActionHasItsThreeParts()
    for _, action in ipairs({ "ChangeStance", "Die", "Flee", "Idle", "MoveTo", "Pursue", "RandomMove", "Reload", "Shoot" }) do
        for _, part in ipairs({ "Initialize", "Update", "CleanUp" }) do
            local name = "SoldierActions_" .. action .. part;
            CheckEqual("function", type(_G[name]), name);
        end
    end
end

function tests.AWeaponIsHungUpAfterTheControllerTookIt()
    local controller, soldier = SoldierOf(agent);
    for step = 1, 30 do
        controller:Update(agent, 33);
    end
    CheckEqual("IDLE", controller:CurrentCommand());
    Check(Animation.GetBonePosition(soldier, "b_muzzle"));
end

function tests.AShotIsABulletAndAnEvent()
    local _, soldier = SoldierOf(agent);
    local before = #Sandbox.GetObjects(sandbox);
    Soldier_Shoot(Soldier.SoldierStates.STAND_FIRE, { agent = agent, soldier = soldier });
    CheckEqual(before + 1, #Sandbox.GetObjects(sandbox));
end

function tests.ACrouchingSoldierKeepsItsFeetOnTheGround()
    local soldier = Soldier_CreateLightSoldier(other);
    Soldier_SetHeight(other, soldier, Soldier.Height.Stand);
    other:SetPosition(Vector.new(5, Soldier.Height.Stand / 2, 5));
    Soldier_SetHeight(other, soldier, Soldier.Height.Crouch);
    CheckNear(Soldier.Height.Crouch / 2, other:GetPosition().y);
    CheckNear(Soldier.Height.Crouch, other:GetHeight());
end

function tests.ASlowerSoldierKeepsItsFall()
    other:SetVelocity(Vector.new(2, -5, 0));
    Check(Soldier_IsMoving(other) and Soldier_IsFalling(other) and not Soldier_OnGround(other));
    Soldier_SlowMovement(other, 33, 2);
    CheckNear(0.91, other:GetVelocity().x);
    CheckNear(-5, other:GetVelocity().y);
    other:SetVelocity(Vector.new());
    Check(not Soldier_IsMoving(other) and not Soldier_IsFalling(other) and Soldier_OnGround(other));
end

function tests.BothWaysToSteerAreForcesAlongTheGround()
    agent:SetPosition(Vector.new(0, 0.8, 0));
    agent:SetPath({ Vector.new(0, 0.8, 0), Vector.new(0, 0.8, 30) }, false);
    for _, steer in ipairs({ Soldier_CalculateSteering, Soldier_CalculateSlowSteering }) do
        local force = steer(agent, 0.033);
        CheckEqual(0, force.y);
        Soldier_ApplySteering(agent, force, 0.033);
    end
    agent:RemovePath();
end

function tests.ARandomPlaceComesWithThePathToIt()
    local floor = Sandbox.CreateBox(sandbox, 20, 1, 20);
    Core.SetMass(floor, 0);
    Core.SetPosition(floor, Vector.new(0, -0.5, 0));
    Sandbox.CreateNavigationMesh(sandbox, "default");
    agent:SetPosition(Vector.new(0, 0.8, 0));
    local place, path = Soldier_PathToRandomPoint(agent);
    CheckNear(0, Vector.Distance(place, path[#path]));
    -- There is none at a place from which no path leads anywhere.
    agent:SetPosition(Vector.new(0, 500, 0));
    CheckEqual(nil, Soldier_PathToRandomPoint(agent));
    agent:SetPosition(Vector.new(0, 0.8, 0));
end

-- Parts that a scenario's own scripts may have: decision branches with evaluators without arguments that return a
-- number, and actions of an unknown structure.
function tests.AMindWorksWithAScenariosOwnParts()
    local keep = { branch = DecisionBranch, action = Action, alive = SoldierEvaluators_IsAlive, die = SoldierActions_DieUpdate };
    DecisionBranch = {
        new = function()
            local branch = { children = {} };
            function branch:SetEvaluator(evaluator) self.evaluator = evaluator; end
            function branch:AddChild(child) table.insert(self.children, child); end
            function branch:Evaluate()
                local choice = self.evaluator();
                Check(type(choice) == "number");
                local child = self.children[choice];
                return child.Evaluate and child:Evaluate() or child;
            end
            return branch;
        end
    };
    local died = 0;
    SoldierEvaluators_IsAlive = function(userData) return userData.lives; end
    SoldierActions_DieUpdate = function(delta, userData) died = died + 1; return keep.action.Status.TERMINATED; end
    Action = {
        Status = keep.action.Status,
        new = function(name, initialize, update, cleanUp, userData)
            local action = {};
            function action:Initialize() end
            function action:Update(delta) self.ended = update(delta, userData); return self.ended; end
            function action:IsTerminated() return self.ended == keep.action.Status.TERMINATED; end
            function action:CleanUp() self.ended = nil; end
            return action;
        end
    };
    local userData = { lives = false };
    local ok, message = pcall(function()
        local tree = SoldierLogic_DecisionTree(userData);
        for step = 1, 3 do
            tree:Update(33);
        end
    end);
    DecisionBranch, Action, SoldierEvaluators_IsAlive, SoldierActions_DieUpdate = keep.branch, keep.action, keep.alive, keep.die;
    Check(ok, message);
    Check(died > 0);
end

function tests.TheInfluenceMapCanBeShown()
    Sandbox.CreateNavigationMesh(sandbox, "default");
    SoldierTactics_InitializeTactics(sandbox);
    SoldierTactics_DrawInfluenceMap(sandbox, SoldierTactics.InfluenceMap.TeamArea);
end

RunTests(tests);
