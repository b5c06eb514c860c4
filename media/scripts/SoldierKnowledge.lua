-- SPDX-License-Identifier: BSD-2-Clause
-- Evaluators for the knowledge sources of soldiers. The blackboard contains the results of AgentSenses.

local kMesh = "default";
local kFreshMillis = 1000;
local kFleeChoices = 32;

local function IsReachable(agent, place)
    return #Sandbox.FindPath(agent:GetSandbox(), kMesh, agent:GetPosition(), place) > 0;
end

-- The nearest living agent of another team that can be reached.
local function Nearest(agent, others)
    local nearest, best;
    for _, other in ipairs(others) do
        local distance = Vector.DistanceSquared(agent:GetPosition(), other:GetPosition());
        local fits = other ~= agent and other:GetHealth() > 0 and other:GetTeam() ~= agent:GetTeam();
        if (fits and (not best or distance < best) and IsReachable(agent, other:GetPosition())) then
            nearest, best = other, distance;
        end
    end
    return nearest;
end

-- The nearest enemy, seen or not.
function SoldierKnowledge_ChooseBestEnemy(userData)
    local agent = userData.agent;
    return { confidence = 1, evaluation = Nearest(agent, Sandbox.GetAgents(agent:GetSandbox())) };
end

-- The nearest enemy seen within the last second.
function SoldierKnowledge_ChooseBestVisibleEnemy(userData)
    local now, seen = Sandbox.GetTimeInMillis(userData.agent:GetSandbox()), {};
    for _, sight in pairs(userData.blackboard:Get("visibleAgents") or {}) do
        if (now - sight.lastSeen <= kFreshMillis) then
            table.insert(seen, sight.agent);
        end
    end
    return { confidence = 1, evaluation = Nearest(userData.agent, seen) };
end

-- The danger of a place: each thing within its range adds its weight.
local function Danger(userData, place)
    local danger = 0;
    local function Count(name, field, reach, weight)
        for _, thing in pairs(userData.blackboard:Get(name) or {}) do
            if (Vector.DistanceSquared(place, thing[field]) < reach * reach) then
                danger = danger + weight;
            end
        end
    end
    Count("bulletImpacts", "position", 10, 0.5);
    Count("bulletShots", "position", 20, 0.25);
    Count("deadEnemies", "seenAt", 20, 1);
    Count("deadFriendlies", "seenAt", 20, 1);
    Count("visibleAgents", "seenAt", 30, 1);
    return danger;
end

-- The least dangerous of several places.
function SoldierKnowledge_ChooseBestFleePosition(userData)
    local sandbox = userData.agent:GetSandbox();
    local best, least;
    for _ = 1, kFleeChoices do
        local place = Sandbox.RandomPoint(sandbox, kMesh);
        local danger = Danger(userData, place);
        if (not least or danger < least) then
            best, least = place, danger;
        end
    end
    return { confidence = 1, evaluation = best };
end
