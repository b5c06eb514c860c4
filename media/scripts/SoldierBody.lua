-- SPDX-License-Identifier: BSD-2-Clause
-- The look of soldiers: gives agents a body with a rifle that walks, runs, turns and falls automatically.

SoldierBody = {
    Mesh = "models/soarbox/soldier.mesh",
    DarkMesh = "models/soarbox/soldier_dark.mesh",
    Rifle = "models/soarbox/rifle.mesh",
};

-- Attaches a rifle to a soldier's right hand and returns it.
function SoldierBody_GiveRifle(parent, soldier)
    local rifle = Core.CreateMesh(parent, SoldierBody.Rifle);
    Animation.AttachToBone(
        soldier, "b_RightHand", rifle, Vector.new(0.04, 0.05, -0.01), Vector.new(98, 97, 0));
    return rifle;
end

-- Gives the agent the body of a soldier that moves with the agent; helmet and arms have its team's colour. style:
-- "ready" (the rifle across the chest), "aim", "crouch", or "unarmed" (no rifle). dark: the darker uniform.
function SoldierBody_Create(agent, style, dark)
    local soldier = Core.CreateMesh(agent, dark and SoldierBody.DarkMesh or SoldierBody.Mesh);
    Core.SetPosition(soldier, Vector.new(0, -agent:GetHeight() / 2, 0));
    local rifle = nil;
    if (style ~= "unarmed") then
        rifle = SoldierBody_GiveRifle(agent, soldier);
    end
    Animation.SetLocomotion(soldier, true, style or "ready");
    return soldier, rifle;
end

-- Plays an animation over the body's own movement, once from its start. Call SoldierBody_Step in each update.
function SoldierBody_Play(soldier, name)
    local animation = Animation.GetAnimation(soldier, name);
    Animation.SetLooping(animation, false);
    Animation.Reset(animation);
    Animation.SetWeight(animation, 0);
    Animation.SetEnabled(animation, true);
    return animation;
end

-- Advances the animation that SoldierBody_Play started, with fades in and out; returns false when it has ended.
function SoldierBody_Step(animation, deltaTimeInMillis)
    local kFade = 0.12;
    Animation.StepAnimation(animation, deltaTimeInMillis);
    local time, length = Animation.GetTime(animation), Animation.GetLength(animation);
    if (time >= length) then
        Animation.SetEnabled(animation, false);
        return false;
    end
    Animation.SetWeight(animation, math.min(1, time / kFade, (length - time) / kFade));
    return true;
end
