-- SPDX-License-Identifier: BSD-2-Clause
-- An agent that is not in the flock, so that a list of the flock is not the list of all agents.
function Agent_Initialize(agent)
    agent:SetTeam("watcher");
    agent:SetPosition(Vector.new(-150, 1, -150));
end
