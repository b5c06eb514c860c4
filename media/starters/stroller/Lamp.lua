-- The script of an agent with its own body: a lamp that counts seconds.
local seconds = 0;

function Agent_Initialize(agent)
    Core.CreateCapsule(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(5, 0, 5));
end

-- What is returned here appears on the agent's input link: ^counter <c> (<c> ^seconds 3).
function Agent_Sense(agent)
    seconds = math.floor(Sandbox.GetTimeInSeconds(agent:GetSandbox()));
    return { counter = { seconds = seconds } };
end

-- Called once for each command: its name and its parameters.
function Agent_Update(agent, deltaTimeInMillis, command, parameters)
    if (command == "shine") then
        print("shines for the " .. parameters.number .. ". time");
    end
end
