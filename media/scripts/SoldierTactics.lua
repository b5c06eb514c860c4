-- SPDX-License-Identifier: BSD-2-Clause
-- Danger and territory on the influence map: layer 0 is danger (below 0), layer 1 the teams (team1 below 0, others
-- above).
require "AgentCommunications";

SoldierTactics = { InfluenceMap = { Danger = 0, TeamArea = 1 } };

local kMesh = "default";
local kUpdateMillis = 500;
local kSoundMillis = 1500;

local sounds = {};
local sinceUpdate = kUpdateMillis;

local function Hear(sandbox, _, type, message)
    if (type == AgentCommunications.EventType.BulletShot or type == AgentCommunications.EventType.BulletImpact) then
        table.insert(sounds, { position = message.position, time = Sandbox.GetTimeInMillis(sandbox) });
    end
end

function SoldierTactics_InitializeTactics(sandbox)
    Sandbox.CreateInfluenceMap(sandbox, kMesh, {
        CellWidth = 2, CellHeight = 1, BoundaryMinOffset = Vector.new(0.18, 0, 0.35) });
    for _, layer in pairs(SoldierTactics.InfluenceMap) do
        Sandbox.SetFalloff(sandbox, layer, 0.2);
        Sandbox.SetInertia(sandbox, layer, 0.5);
    end
    Sandbox.AddEventCallback(sandbox, sandbox, Hear);
end

local function Mark(sandbox, layer, position, value)
    Sandbox.SetInfluence(sandbox, layer, Sandbox.FindClosestPoint(sandbox, kMesh, position), value);
end

function SoldierTactics_UpdateDanger(sandbox)
    local now, layer = Sandbox.GetTimeInMillis(sandbox), SoldierTactics.InfluenceMap.Danger;
    Sandbox.ClearInfluenceMap(sandbox, layer);
    for index = #sounds, 1, -1 do
        if (now - sounds[index].time > kSoundMillis) then
            table.remove(sounds, index);
        else
            Mark(sandbox, layer, sounds[index].position, -1);
        end
    end
    for _, agent in ipairs(Sandbox.GetAgents(sandbox)) do
        if (agent:GetHealth() <= 0) then
            Mark(sandbox, layer, agent:GetPosition(), -1);
        end
    end
    Sandbox.SpreadInfluenceMap(sandbox, layer);
end

function SoldierTactics_UpdateTeamAreas(sandbox)
    local layer = SoldierTactics.InfluenceMap.TeamArea;
    Sandbox.ClearInfluenceMap(sandbox, layer);
    for _, agent in ipairs(Sandbox.GetAgents(sandbox)) do
        if (agent:GetHealth() > 0) then
            Mark(sandbox, layer, agent:GetPosition(), agent:GetTeam() == "team1" and -1 or 1);
        end
    end
    Sandbox.SpreadInfluenceMap(sandbox, layer);
end

-- Draws a layer for this step: red for values above 0, blue for values below.
function SoldierTactics_DrawInfluenceMap(sandbox, layer)
    Sandbox.DrawInfluenceMap(sandbox, layer, { 1, 0, 0, 0.8 }, { 0, 0, 0, 0.1 }, { 0, 0, 1, 0.8 });
end

-- Call it once per step of the sandbox; true if the maps were computed again.
function SoldierTactics_UpdateTactics(sandbox, deltaTimeInMillis)
    sinceUpdate = sinceUpdate + deltaTimeInMillis;
    if (sinceUpdate < kUpdateMillis) then
        return false;
    end
    sinceUpdate = 0;
    SoldierTactics_UpdateDanger(sandbox);
    SoldierTactics_UpdateTeamAreas(sandbox);
    SoldierTactics_DrawInfluenceMap(sandbox, SoldierTactics.InfluenceMap.TeamArea);
    return true;
end
