-- SPDX-License-Identifier: BSD-2-Clause
-- What a soldier's decisions ask. userData has agent and blackboard; the blackboard knows enemy, ammo and maxHealth.

local kCriticalShare = 0.2;
local kReached = 1.5;
local kShootRange = 3;

function SoldierEvaluators_True(userData)
    return true;
end

function SoldierEvaluators_IsAlive(userData)
    return userData.agent:GetHealth() > 0 and userData.blackboard:Get("alive") ~= false;
end

function SoldierEvaluators_IsNotAlive(userData)
    return not SoldierEvaluators_IsAlive(userData);
end

function SoldierEvaluators_HasCriticalHealth(userData)
    return userData.agent:GetHealth() < userData.blackboard:Get("maxHealth") * kCriticalShare;
end

function SoldierEvaluators_HasEnemy(userData)
    return userData.blackboard:Get("enemy") ~= nil;
end

function SoldierEvaluators_HasNoEnemy(userData)
    return not SoldierEvaluators_HasEnemy(userData);
end

function SoldierEvaluators_HasAmmo(userData)
    return (userData.blackboard:Get("ammo") or 0) > 0;
end

function SoldierEvaluators_HasNoAmmo(userData)
    return not SoldierEvaluators_HasAmmo(userData);
end

function SoldierEvaluators_CanShootAgent(userData)
    local enemy = userData.blackboard:Get("enemy");
    return enemy ~= nil and enemy:GetHealth() > 0
        and Vector.Distance(userData.agent:GetPosition(), enemy:GetPosition()) < kShootRange;
end

function SoldierEvaluators_HasMovePosition(userData)
    return Vector.Distance(userData.agent:GetPosition(), userData.agent:GetTarget()) > kReached;
end

function SoldierEvaluators_IsAtMovePosition(userData)
    return not SoldierEvaluators_HasMovePosition(userData);
end

function SoldierEvaluators_Random(userData)
    return math.random() >= 0.5;
end
