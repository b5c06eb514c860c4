-- stroller: a world made by a script, with an agent whose mind is Soar rules.
require "SoarWorld";

local PlainInitialize = Sandbox_Initialize;

function Sandbox_Initialize(sandbox)
    PlainInitialize(sandbox);
    -- A body that comes with the program carries out the commands of docs/commands.md.
    Sandbox.CreateSoarAgent(sandbox, {
        name = "stroller", rules = "stroller.soar", body = "walker", team = "blue", position = Vector.new(0, 0, 0),
        senses = { sight = 40 },
    });
    -- A body of your own: its script gets each command with its parameters.
    Sandbox.CreateSoarAgent(sandbox, "Lamp.lua", "lamp.soar", { name = "lamp" });
end
