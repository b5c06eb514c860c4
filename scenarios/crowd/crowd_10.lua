-- The crowd with 10 agents.
require "Crowd";

function Sandbox_Initialize(sandbox)
    Crowd_Create(sandbox, 10);
end
