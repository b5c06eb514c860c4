-- The thesis' world: a leader whose mind is Lua, four followers and a waypoint agent whose minds are Soar rules.
require "ThesisWorld";

function Sandbox_Initialize(sandbox)
    ThesisWorld_Initialize(sandbox);
    Sandbox.CreateAgent(sandbox, "SeekingLuaAgent.lua");
    for i = 1, 4 do
        Sandbox.CreateSoarFollowerAgent(sandbox, "FollowerAgent.lua");
    end
    Sandbox.CreateSoarWaypointAgent(sandbox, "WaypointsAgent.lua");
end
