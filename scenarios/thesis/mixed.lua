-- One group of both kinds: a Soar leader, followed by two Soar agents and two Lua agents.
require "ThesisWorld";

function Sandbox_Initialize(sandbox)
    ThesisWorld_Initialize(sandbox);
    Sandbox.CreateSoarSeekingAgent(sandbox, "SeekingAgent.lua");
    for i = 1, 2 do
        Sandbox.CreateSoarFollowerAgent(sandbox, "FollowerAgent.lua");
        Sandbox.CreateAgent(sandbox, "FollowerLuaAgent.lua");
    end
end
