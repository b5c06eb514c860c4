-- SPDX-License-Identifier: BSD-2-Clause
-- Messages. The test continues after the steps that deliver them.
require "Check";
require "AgentCommunications";

local heard = {};

local function Listen(listener, team)
    listener:SetTeam(team);
    AgentCommunications_AddEventCallback({ agent = listener, team = team }, AgentCommunications.EventType.EnemySighted,
        function(userData, type, message)
            table.insert(heard, userData.team .. " heard " .. type .. " at " .. message.place.x);
        end);
end

Listen(agent, "red");
Listen(other, "blue");
AgentCommunications_SendTeamMessage(sandbox, agent, "EnemySighted", { place = Vector.new(1, 0, 0) });
AgentCommunications_SendMessage(sandbox, "EnemySighted", { place = Vector.new(2, 0, 0) });
AgentCommunications_SendMessage(sandbox, "BulletShot", { place = Vector.new(3, 0, 0) });

function Finish()
    RunTests({
        TeamMessagesReachTheTeamAndOthersEverybody = function()
            CheckEqual(
                "red heard EnemySighted at 1|red heard EnemySighted at 2|blue heard EnemySighted at 2",
                table.concat(heard, "|"));
        end
    });
end
