-- The crowd with 60 agents: enough to watch them avoid each other.
require "Crowd";

function Sandbox_Initialize(sandbox)
    Crowd_Create(sandbox, 60);
end
