-- SPDX-License-Identifier: BSD-2-Clause
-- A state of an animation state machine: an animation, whether it loops, and its rate (1: its own speed).

AnimationState = {};

function AnimationState.new(name, animation, looping, rate)
    return { name_ = name, animation_ = animation, looping_ = looping == true, rate_ = rate or 1 };
end
