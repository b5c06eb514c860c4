-- The crowd with 10000 agents.
require "Crowd";

function Sandbox_Initialize(sandbox)
    Crowd_Create(sandbox, 10000);
end
