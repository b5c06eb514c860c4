-- SPDX-License-Identifier: BSD-2-Clause
-- A state of a state machine: a name and its action.

FiniteState = {};

function FiniteState.new(name, action)
    return { name_ = name, action_ = action };
end
