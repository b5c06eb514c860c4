-- The body of a follower whose mind says "follow" or "stop".
require "AgentUtilities";

local leader;

function Agent_Cleanup(agent)
end

function Agent_HandleEvent(agent, event)
end

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(math.random(-50, 50), 0, math.random(-50, 50)));
    local everybody = Sandbox.GetAgents(agent:GetSandbox());
    leader = everybody[1];
    Agent.SetLeader(agent, leader);
end

function Agent_Update(agent, deltaTimeInMillis, soarCommand)
    local room = Agent.ForceToSeparate(agent, 3, 45, { leader });
    local force;
    if (soarCommand == "follow") then
        local everybody = Sandbox.GetAgents(agent:GetSandbox());
        force = room + Agent.ForceToCombine(agent, 100, 180, { leader }) + Agent.ForceToSeparate(agent, 2, 180, everybody) * 1.15;
    elseif (soarCommand == "stop") then
        force = room;
    end
    if (force) then
        AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
        AgentUtilities_ClampHorizontalSpeed(agent);
    end
    Core.DrawCircle(agent:GetPosition(), 1, Vector.new(1, 1, 0));
    Core.DrawCircle(leader:GetPosition(), agent:GetTargetRadius(), Vector.new(1, 0, 0));
    Core.DrawLine(agent:GetPosition(), leader:GetPosition(), Vector.new(0, 1, 0));
end
