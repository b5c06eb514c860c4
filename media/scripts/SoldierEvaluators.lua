-- SPDX-License-Identifier: BSD-2-Clause
-- Questions about a soldier that its logic asks: SoldierEvaluators_NAME(userData), with the agent and its blackboard.

-- Health of which a soldier says that it is critical, as a share of what it began with.
local kCriticalShare = 0.2;
local kShootRange = 3;
local kArrived = 1.5;

local ask = {};

function ask.True()
    return true;
end

function ask.Random()
    return math.random() < 0.5;
end

function ask.IsAlive(userData)
    return userData.agent:GetHealth() > 0;
end

function ask.HasCriticalHealth(userData)
    local full = userData.blackboard:Get("maxHealth") or 0;
    return userData.agent:GetHealth() < full * kCriticalShare;
end

function ask.HasEnemy(userData)
    return userData.blackboard:Get("enemy") ~= nil;
end

function ask.HasAmmo(userData)
    return (userData.blackboard:Get("ammo") or 0) > 0;
end

local function Gap(userData, place)
    return Vector.Distance(userData.agent:GetPosition(), place);
end

function ask.CanShootAgent(userData)
    local enemy = userData.blackboard:Get("enemy");
    return enemy ~= nil and enemy:GetHealth() > 0 and Gap(userData, enemy:GetPosition()) < kShootRange;
end

function ask.IsAtMovePosition(userData)
    return Gap(userData, userData.agent:GetTarget()) <= kArrived;
end

-- Those that are another one's opposite.
local kOpposites = {
    IsNotAlive = "IsAlive", HasNoEnemy = "HasEnemy", HasNoAmmo = "HasAmmo", HasMovePosition = "IsAtMovePosition"
};
for name, other in pairs(kOpposites) do
    local question = ask[other];
    ask[name] = function(userData)
        return not question(userData);
    end;
end

for name, question in pairs(ask) do
    _G["SoldierEvaluators_" .. name] = question;
end
