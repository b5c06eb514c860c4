-- A percept and a command of your own. The harbour is given (Harbour.lua): Harbour.IsDark(), Harbour.IsLit(), Harbour.SetLamp(on).
require "Harbour";

-- What the mind perceives in each tick, as a table: below ^io.input-link.
function Sandbox_Sense(sandbox, agent)
    return { sky = { light = Harbour.IsDark() and "dark" or "bright" }, lamp = { lit = Harbour.IsLit() } };
end

-- Carries out a command. Returns nothing, or a word: then the command gets ^status error and this ^reason.
function Sandbox_Command(sandbox, agent, command, parameters)
    if (command ~= "lamp") then return "unknown-command"; end
    if (parameters.switch == true) then
        Harbour.SetLamp(true);
    elseif (parameters.switch == false) then
        Harbour.SetLamp(false);
    else
        return "no-such-switch";
    end
end
