-- SPDX-License-Identifier: BSD-2-Clause
-- A transition of a state: its target, and the function that says when it is open.

FiniteStateTransition = {};

function FiniteStateTransition.new(toStateName, evaluator)
    return { toStateName_ = toStateName, evaluator_ = evaluator };
end
