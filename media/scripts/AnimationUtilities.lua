-- SPDX-License-Identifier: BSD-2-Clause
-- Cross-fades between animations. Times are in seconds.

local kShortest = 0.01;

-- From 0 at startTime to 1 at the end of the blend.
local function Share(blendTime, startTime, now)
    return math.max(0, math.min(1, (now - startTime) / math.max(blendTime, kShortest)));
end

-- Each returns true when the blend has ended.
function AnimationUtilities_LinearBlendIn(animation, blendTime, startTime, now)
    local share = Share(blendTime, startTime, now);
    Animation.SetWeight(animation, share);
    return share >= 1;
end

function AnimationUtilities_LinearBlendOut(animation, blendTime, startTime, now)
    local share = Share(blendTime, startTime, now);
    Animation.SetWeight(animation, 1 - share);
    return share >= 1;
end

function AnimationUtilities_LinearBlendTo(from, to, blendTime, startTime, now)
    AnimationUtilities_LinearBlendOut(from, blendTime, startTime, now);
    return AnimationUtilities_LinearBlendIn(to, blendTime, startTime, now);
end

-- Synchronises an animation with a reference of any length.
function AnimationUtilities_StepSynced(reference, animation)
    Animation.SetTime(animation, Animation.GetNormalizedTime(reference) * Animation.GetLength(animation));
end
