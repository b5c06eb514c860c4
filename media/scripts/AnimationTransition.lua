-- SPDX-License-Identifier: BSD-2-Clause
-- A cross-fade of an animation state machine, in seconds: how long before the end of the old animation it may start,
-- its duration, and the start time in the new animation.

AnimationTransition = {};

function AnimationTransition.new(blendOutWindow, duration, blendInWindow)
    return {
        blendOutWindow_ = blendOutWindow or 0,
        duration_ = duration or 0.2,
        blendInWindow_ = blendInWindow or 0
    };
end
