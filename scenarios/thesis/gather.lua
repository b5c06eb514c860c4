-- The leader walks to the middle and waits there; its four Soar followers gather round it.
require "ThesisWorld";

function Sandbox_Initialize(sandbox)
    ThesisWorld_Initialize(sandbox);
    Sandbox.CreateAgent(sandbox, "WaitingLuaAgent.lua");
    for i = 1, 4 do
        Sandbox.CreateSoarFollowerAgent(sandbox, "FollowerAgent.lua");
    end
end
