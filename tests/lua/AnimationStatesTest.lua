-- SPDX-License-Identifier: BSD-2-Clause
-- Cross-fades and the animation state machine, with a soldier's movements.
require "Check";
require "AnimationStateMachine";
require "SoldierBody";

local tests = {};
local kStep = 33;

local function Movements()
    local soldier = Core.CreateMesh(sandbox, SoldierBody.Mesh);
    return Animation.GetAnimation(soldier, "stand_idle_aim"), Animation.GetAnimation(soldier, "stand_reload"),
        Animation.GetAnimation(soldier, "stand_fire_one_shot");
end

-- Transitions: from idle to reload at any time, and from reload to idle at its end. There is none from fire.
local function Machine()
    local idle, reload, fire = Movements();
    local machine = AnimationStateMachine.new();
    machine:AddState("idle", idle, true);
    machine:AddState("reload", reload);
    machine:AddState("fire", fire, true);
    machine:AddTransition("idle", "reload", Animation.GetLength(idle), 0.2);
    machine:AddTransition("idle", "fire", Animation.GetLength(idle), 0.1);
    machine:AddTransition("reload", "idle", 0.2, 0.2);
    machine:AddTransition("idle", "nothing");
    return machine, idle, reload, fire;
end

-- Runs for some milliseconds; calls check() after each step.
local function Run(machine, millis, check)
    for _ = 1, math.ceil(millis / kStep) do
        machine.now = (machine.now or 0) + kStep;
        machine:Update(kStep, machine.now);
        if (check) then
            check();
        end
    end
end

function tests.BlendsGoFromZeroToOne()
    local idle, reload = Movements();
    Check(not AnimationUtilities_LinearBlendIn(idle, 2, 10, 10.5));
    CheckNear(0.25, Animation.GetWeight(idle));
    Check(AnimationUtilities_LinearBlendOut(idle, 2, 10, 13));
    CheckEqual(0, Animation.GetWeight(idle));
    AnimationUtilities_LinearBlendTo(idle, reload, 0, 5, 5.02);
    CheckEqual(1, Animation.GetWeight(reload));
    Animation.SetNormalizedTime(idle, 0.5);
    AnimationUtilities_StepSynced(idle, reload);
    CheckNear(0.5, Animation.GetNormalizedTime(reload));
end

function tests.TheFirstRequestIsServedAtOnceAndWrongOnesNever()
    local machine, idle = Machine();
    CheckEqual(nil, machine:GetCurrentStateName());
    Check(not machine:RequestState("nothing"));
    Check(machine:RequestState("idle"));
    CheckEqual("idle", machine:GetCurrentStateName());
    Check(Animation.IsEnabled(idle) and Animation.IsLooping(idle));
    Check(machine:ContainsState("fire") and not machine:ContainsState("nothing"));
    Check(machine:ContainsTransition("idle", "fire") and not machine:ContainsTransition("fire", "idle"));
end

function tests.WeightsSumToOneInAFadeAndTheStateComesBack()
    local machine, idle, reload = Machine();
    machine:RequestState("idle");
    Run(machine, 300);
    Check(machine:RequestState("reload"));
    Check(not machine:RequestState("fire"));
    Run(machine, 264, function()
        CheckNear(1, Animation.GetWeight(idle) + Animation.GetWeight(reload));
    end);
    CheckEqual("reload", machine:GetCurrentStateName());
    Check(not Animation.IsEnabled(idle) and not Animation.IsLooping(reload));
    Check(machine:RequestState("idle"));
    Run(machine, 500);
    CheckEqual("reload", machine:GetCurrentStateName());
    Run(machine, Animation.GetLength(reload) * 1000);
    CheckEqual("idle", machine:GetCurrentStateName());
    CheckEqual(1, Animation.GetWeight(idle));
end

function tests.WithoutATransitionTheStateChangesAtTheEnd()
    local machine, idle, reload, fire = Machine();
    machine:SetState("fire");
    machine:RequestState("idle");
    Run(machine, Animation.GetLength(fire) * 1000 - 2 * kStep);
    CheckEqual("fire", machine:GetCurrentStateName());
    Run(machine, 3 * kStep);
    CheckEqual("idle", machine:GetCurrentStateName());
    Check(not Animation.IsEnabled(fire));
end

function tests.CallbacksHearEachStartAndEachLoop()
    local machine, idle, reload, fire = Machine();
    local heard = 0;
    machine:AddStateCallback("fire", function(name, data)
        CheckEqual("fire", name);
        heard = heard + data;
    end, 1);
    machine:RequestState("idle");
    machine:RequestState("fire");
    Run(machine, 3 * Animation.GetLength(fire) * 1000 + 3 * kStep);
    CheckEqual(4, heard);
end

RunTests(tests);
