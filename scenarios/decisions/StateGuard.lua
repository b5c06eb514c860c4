-- SPDX-License-Identifier: BSD-2-Clause
-- A guard with a state machine as its mind: the first open transition of a state leads to the next state.
require "FiniteStateMachine";
require "GuardBody";

local guard, machine;

function Agent_Initialize(agent)
    guard = GuardBody_Create(agent);
    local patrol, chase, rest = GuardBody_Actions(guard);
    machine = FiniteStateMachine.new(guard);
    machine:AddState("patrol", patrol);
    machine:AddState("chase", chase);
    machine:AddState("rest", rest);
    local function Otherwise()
        return true;
    end
    for _, from in ipairs({ "patrol", "chase", "rest" }) do
        machine:AddTransition(from, "rest", GuardBody_IsTired);
        machine:AddTransition(from, "chase", GuardBody_SeesIntruder);
        machine:AddTransition(from, "patrol", Otherwise);
    end
    machine:SetState("patrol");
end

function Agent_Update(agent, deltaTimeInMillis)
    machine:Update(deltaTimeInMillis);
    GuardBody_Update(guard, deltaTimeInMillis);
end
