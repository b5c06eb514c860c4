-- SPDX-License-Identifier: BSD-2-Clause
-- A way out of a state: where to, and the function that says when.

FiniteStateTransition = {};

function FiniteStateTransition.new(toStateName, evaluator)
    return { toStateName_ = toStateName, evaluator_ = evaluator };
end
