-- A percept and a command of your own. The harbour is given (Harbour.lua): Harbour.IsDark(), Harbour.IsLit(), Harbour.SetLamp(on).
require "Harbour";

-- What the mind perceives in each tick, as a table: below ^io.input-link.
function Sandbox_Sense(sandbox, agent)
    -- 1. Return a table with sky and lamp, which are tables too: ^sky.light is dark or bright, ^lamp.lit is yes or no.
    return {};
end

-- Carries out a command. Returns nothing, or a word: then the command gets ^status error and this ^reason.
function Sandbox_Command(sandbox, agent, command, parameters)
    -- 2. lamp with ^switch on or off lights the lamp or puts it out; another switch is an error, no-such-switch.
    return "unknown-command";
end
