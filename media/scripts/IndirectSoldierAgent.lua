-- SPDX-License-Identifier: BSD-2-Clause
-- A complete soldier: senses, messages, a blackboard, a behavior tree, and a body that executes commands. Agents with
-- even numbers are in team1, in dark uniforms; the others in team2. Sandbox.CreateAgent can use this script directly. A
-- scenario's own agent may require it and add to IndirectSoldier.userData, whose mind is IndirectSoldier.mind.
require "AgentSenses";
require "Blackboard";
require "KnowledgeSource";
require "Soldier";
require "SoldierController";
require "SoldierKnowledge";
require "SoldierLogic";

IndirectSoldier = { userData = {} };

local kMaxAmmo = 10;
local kEnemyMillis = 300;

function Agent_Initialize(agent)
    local userData, board = IndirectSoldier.userData, Blackboard.new(IndirectSoldier.userData);
    agent:SetTeam(agent:GetId() % 2 == 0 and "team1" or "team2");
    agent:SetMaxSpeed(Soldier.Speed.Stand);
    local create = agent:GetTeam() == "team1" and Soldier_CreateSoldier or Soldier_CreateLightSoldier;
    local weapon = Soldier_CreateWeapon(agent);
    userData.agent = agent;
    userData.soldier = create(agent);
    userData.controller = SoldierController.new(agent, userData.soldier, weapon);
    userData.blackboard = board;
    Soldier_AttachWeapon(userData.soldier, weapon);

    board:Set("alive", true);
    board:Set("ammo", kMaxAmmo);
    board:Set("maxAmmo", kMaxAmmo);
    board:Set("maxHealth", agent:GetHealth());
    board:AddSource("enemy", KnowledgeSource.new(SoldierKnowledge_ChooseBestVisibleEnemy, kEnemyMillis));
    board:AddSource("bestFleePosition", KnowledgeSource.new(SoldierKnowledge_ChooseBestFleePosition));

    AgentSenses_InitializeSenses(userData);
    IndirectSoldier.mind = SoldierLogic_BehaviorTree(userData);
end

function Agent_Update(agent, deltaTimeInMillis)
    local userData = IndirectSoldier.userData;
    if (userData.blackboard:Get("alive")) then
        AgentSenses_UpdateSenses(agent:GetSandbox(), userData, deltaTimeInMillis);
        IndirectSoldier.mind:Update(deltaTimeInMillis);
    end
    userData.controller:Update(agent, deltaTimeInMillis);
end
