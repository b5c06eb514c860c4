-- The crowd with 1 agent.
require "Crowd";

function Sandbox_Initialize(sandbox)
    Crowd_Create(sandbox, 1);
end
