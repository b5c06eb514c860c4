-- As Sandbox.lua, but the leader decides by Soar rules too.
require "ThesisWorld";

function Sandbox_Initialize(sandbox)
    ThesisWorld_Initialize(sandbox);
    Sandbox.CreateSoarSeekingAgent(sandbox, "SeekingAgent.lua");
    for i = 1, 4 do
        Sandbox.CreateSoarFollowerAgent(sandbox, "FollowerAgent.lua");
    end
    Sandbox.CreateSoarWaypointAgent(sandbox, "WaypointsAgent.lua");
end
