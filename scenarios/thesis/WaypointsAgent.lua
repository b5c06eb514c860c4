-- Body of the Soar waypoint agent (waypointagent.soar): on "nextwaypoint" it goes on to the next of five points.
require "Steering";

local kWaypoints = {
    Vector.new(0, 0, 0), Vector.new(20, 0, 0), Vector.new(20, 0, 30), Vector.new(-20, 0, 0), Vector.new(-20, 0, 10),
};
local index = 0;

function Agent_Initialize(agent)
    Steering_CreateBody(agent);
    agent:SetTarget(Vector.new(50, 0, 0));
    agent:SetTargetRadius(2.5);
end

function Agent_Update(agent, deltaTimeInMillis, soarCommand)
    Steering_WalkToTarget(agent, deltaTimeInMillis);
    if (soarCommand == "nextwaypoint") then
        index = index % #kWaypoints + 1;
        agent:SetTarget(kWaypoints[index]);
    end
    for _, waypoint in ipairs(kWaypoints) do
        Core.DrawCircle(waypoint, 0.5, Vector.new(0.2, 0.6, 1));
    end
    Steering_DrawGoal(agent, agent:GetTarget());
end
