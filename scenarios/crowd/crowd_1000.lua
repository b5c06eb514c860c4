-- The crowd with 1000 agents.
require "Crowd";

function Sandbox_Initialize(sandbox)
    Crowd_Create(sandbox, 1000);
end
