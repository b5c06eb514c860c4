-- The crowd with 100 agents.
require "Crowd";

function Sandbox_Initialize(sandbox)
    Crowd_Create(sandbox, 100);
end
