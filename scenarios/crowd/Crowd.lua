-- A crowd of seekers on one plain, half of them with Soar minds, half with Lua minds. Used by the benchmark too.
require "ThesisWorld";

function Crowd_Create(sandbox, count)
    ThesisWorld_Initialize(sandbox);
    for i = 1, count do
        if (i % 2 == 1) then
            Sandbox.CreateSoarSeekingAgent(sandbox, "CrowdAgent.lua");
        else
            Sandbox.CreateAgent(sandbox, "CrowdLuaAgent.lua");
        end
    end
end
