-- SPDX-License-Identifier: BSD-2-Clause
-- A plain with a flock of this many agents, 2 m apart, and one agent of another team. The flock's agents run `script`.
function Flock_Create(sandbox, count, script)
    Sandbox.CreatePlane(sandbox, 400, 400);
    local row = math.ceil(math.sqrt(count));
    for number = 0, count - 1 do
        local agent = Sandbox.CreateAgent(sandbox, script);
        agent:SetPosition(Vector.new((number % row) * 2 - row, 1, math.floor(number / row) * 2 - row));
    end
    Sandbox.CreateAgent(sandbox, "Watcher.lua");
end
