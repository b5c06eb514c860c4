-- SPDX-License-Identifier: BSD-2-Clause
-- A state of an animation state machine: one animation, looping or not, at some rate (1 is its own).

AnimationState = {};

function AnimationState.new(name, animation, looping, rate)
    return { name_ = name, animation_ = animation, looping_ = looping == true, rate_ = rate or 1 };
end
