-- The body of an agent that goes on to the next of five points when its mind says "nextwaypoint".
require "AgentUtilities";

local points = {};
for _, place in ipairs({ { 0, 0 }, { 20, 0 }, { 20, 30 }, { -20, 0 }, { -20, 10 } }) do
    points[#points + 1] = Vector.new(place[1], 0, place[2]);
end
local current = 0;

function Agent_Cleanup(agent)
end

function Agent_HandleEvent(agent, event)
end

function Agent_Initialize(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    Agent.SetTarget(agent, Vector.new(50, 0, 0));
    Agent.SetTargetRadius(agent, 2.5);
end

function Agent_Update(agent, deltaTimeInMillis, soarCommand)
    local goal = Agent.GetTarget(agent);
    local avoid = Agent.ForceToAvoidAgents(agent, 1.5) + Agent.ForceToAvoidObjects(agent, 1.5);
    AgentUtilities_ApplyPhysicsSteeringForce(agent, Agent.ForceToPosition(agent, goal) + avoid * 3, deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
    if (soarCommand == "nextwaypoint") then
        current = current % #points + 1;
        Agent.SetTarget(agent, points[current]);
    end
    Core.DrawCircle(goal, Agent.GetTargetRadius(agent), Vector.new(1, 0, 0));
    Core.DrawLine(Agent.GetPosition(agent), goal, Vector.new(0, 1, 0));
    Core.DrawSquare(Vector.new(), 100, Vector.new(1, 0, 0));
end
