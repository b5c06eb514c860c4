-- SPDX-License-Identifier: BSD-2-Clause
-- A soldier with everything: senses, messages, a blackboard, a behavior tree, and a body that does as it is told. Agents
-- with even numbers are of team1, in dark; the others of team2.
require "AgentSenses";
require "Blackboard";
require "SoldierController";
require "SoldierKnowledge";
require "SoldierLogic";

local kMaxHealth = 100;
local kMaxAmmo = 10;

local userData = {};
local mind;
local lastDeed, lastHealth;

function Agent_Initialize(agent)
    agent:SetTeam(agent:GetId() % 2 == 0 and "team1" or "team2");
    agent:SetHealth(kMaxHealth);
    agent:SetMaxSpeed(Soldier.Speed.STAND);

    local create = agent:GetTeam() == "team1" and Soldier_CreateDarkSoldier or Soldier_CreateLightSoldier;
    userData.agent = agent;
    userData.soldier = create(agent);
    userData.controller = SoldierController.new(agent, userData.soldier, Soldier_CreateWeapon(agent));

    local board = Blackboard.new(userData);
    userData.blackboard = board;
    board:Set("alive", true);
    board:Set("ammo", kMaxAmmo);
    board:Set("maxAmmo", kMaxAmmo);
    board:Set("maxHealth", kMaxHealth);
    board:AddSource("enemy", KnowledgeSource.new(SoldierKnowledge_ChooseBestVisibleEnemy, 300));
    board:AddSource("bestFleePosition", KnowledgeSource.new(SoldierKnowledge_ChooseBestFleePosition));

    AgentSenses_InitializeSenses(userData);
    mind = SoldierLogic_BehaviorTree(userData);
end

local function Report(agent)
    local deed = mind:GetCurrentActionName();
    if (deed and deed ~= lastDeed) then
        print(agent:GetId() .. " " .. deed);
        lastDeed = deed;
    end
    if (lastHealth and agent:GetHealth() < lastHealth) then
        print(agent:GetId() .. " is hit");
    end
    lastHealth = agent:GetHealth();
end

function Agent_Update(agent, deltaTimeInMillis)
    if (userData.blackboard:Get("alive")) then
        AgentSenses_UpdateSenses(agent:GetSandbox(), userData, deltaTimeInMillis);
        mind:Update(deltaTimeInMillis);
        Report(agent);
    end
    userData.controller:Update(agent, deltaTimeInMillis);
end
