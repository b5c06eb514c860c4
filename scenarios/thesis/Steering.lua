-- What the agents of this scenario have in common: their looks, how they walk, and what they draw.
require "AgentUtilities";

function Steering_CreateBody(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
end

-- Applies a force for this step and keeps the agent below its top speed.
function Steering_Apply(agent, force, deltaTimeInMillis)
    AgentUtilities_ApplyPhysicsSteeringForce(agent, force, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
end

-- Walks towards the agent's target, round agents and objects that are in the way.
function Steering_WalkToTarget(agent, deltaTimeInMillis)
    agent:WalkToTarget(deltaTimeInMillis / 1000);
end

-- Closes up to the leader, but keeps a distance from everybody.
function Steering_Follow(agent, leader, deltaTimeInMillis)
    local everybody = Sandbox.GetAgents(agent:GetSandbox());
    local force = agent:ForceToCombine(100, 180, { leader })
        + agent:ForceToSeparate(2, 180, everybody) * 1.15
        + agent:ForceToSeparate(3, 45, { leader });
    Steering_Apply(agent, force, deltaTimeInMillis);
end

-- The first agent of the sandbox that is not this one.
function Steering_FirstOther(agent)
    for _, other in ipairs(Sandbox.GetAgents(agent:GetSandbox())) do
        if (other ~= agent) then
            return other;
        end
    end
end

-- A red ring round the goal and a green line to it.
function Steering_DrawGoal(agent, goal)
    Core.DrawCircle(goal, agent:GetTargetRadius(), Vector.new(1, 0, 0));
    Core.DrawLine(agent:GetPosition(), goal, Vector.new(0, 1, 0));
end
