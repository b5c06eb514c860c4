-- SPDX-License-Identifier: BSD-2-Clause
-- The conditions that soldiers' minds evaluate before they act. SoldierEvaluators_NAME(userData) returns true or false;
-- userData is that of SoldierActions. Most conditions come in pairs of which exactly one is true.

local kReach = { shot = 3, place = 1.5 };  -- In metres, from the middle of the body.
local kWeak = 0.2;                         -- As a share of the health at the beginning.

-- Adds a condition, and under `otherwise` its negation.
local function Add(name, answer, otherwise)
    _G["SoldierEvaluators_" .. name] = answer;
    if (otherwise) then
        _G["SoldierEvaluators_" .. otherwise] = function(userData) return not answer(userData); end;
    end
end

local function Number(userData, name)
    return userData.blackboard:Get(name) or 0;
end

local function Within(reach, userData, place)
    local way = place - userData.agent:GetPosition();
    return Vector.Length(way) <= reach;
end

local function IsOnItsFeet(agent)
    return agent:GetHealth() > 0;
end

Add("True", function() return true; end);
Add("Random", function() return math.random() < 0.5; end);
Add("IsAlive", function(userData) return IsOnItsFeet(userData.agent); end, "IsNotAlive");
Add("HasAmmo", function(userData) return Number(userData, "ammo") >= 1; end, "HasNoAmmo");
Add("HasEnemy", function(userData) return userData.blackboard:Get("enemy") ~= nil; end, "HasNoEnemy");
Add("IsAtMovePosition", function(userData)
    return Within(kReach.place, userData, userData.agent:GetTarget());
end, "HasMovePosition");
Add("HasCriticalHealth", function(userData)
    return userData.agent:GetHealth() < kWeak * Number(userData, "maxHealth");
end);
Add("CanShootAgent", function(userData)
    local aim = userData.blackboard:Get("enemy");
    if (aim == nil or not IsOnItsFeet(aim)) then
        return false;
    end
    return Within(kReach.shot, userData, aim:GetPosition());
end);
