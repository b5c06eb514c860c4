// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

namespace soarbox::script {
namespace {

constexpr ApiFunction kAnimationFunctions[] = {
    {"Animation.AttachToBone",
     "mesh: Scene, bone: string, other: Node, offset: Vector [m] = none, rotation: Vector [deg] = none", "",
     "Attaches a node to a bone. The node then moves with the bone, and its position and rotation are relative to the "
     "bone.",
     R"(local hat = Core.CreateBox(sandbox, 0.2, 0.1, 0.2)
Animation.AttachToBone(mesh, "b_Head1", hat, Vector.new(0, 0.2, 0)))"},
    {"Animation.GetAnimation", "mesh: Scene, name: string", "Animation",
     "One of the mesh's animations. Initially it is disabled and looping, has weight 1, and is at its start.",
     R"(local idle = Animation.GetAnimation(mesh, "stand_idle_aim")
Animation.SetEnabled(idle, true))"},
    {"Animation.GetAnimationNames", "mesh: Scene", "table of string",
     "The names of the mesh's animations, counted from 1.",
     R"(for _, name in ipairs(Animation.GetAnimationNames(mesh)) do assert(Animation.GetAnimation(mesh, name)) end)",
     true},
    {"Animation.GetBoneNames", "mesh: Scene", "table of string",
     "The names of the bones, counted from 0; {} without bones.",
     R"(print(Animation.GetBoneNames(mesh)[0] ~= nil)  --> true)"},
    {"Animation.GetBonePosition", "mesh: Scene, bone: string", "Vector [m]",
     "The position of a bone in the world. Bones of attached meshes are found, too. Nothing for other names.",
     R"(print(Animation.GetBonePosition(mesh, "b_Head1").y > 1)  --> true)"},
    {"Animation.GetBoneRotation", "mesh: Scene, bone: string", "Vector [deg]", "The rotation of a bone in the world.",
     R"(local turn = Animation.GetBoneRotation(mesh, "b_Head1"))"},
    {"Animation.GetLength", "animation: Animation", "number [s]", "The length of the animation.",
     R"(print(Animation.GetLength(animation) > 0)  --> true)"},
    {"Animation.GetName", "animation: Animation", "string", "The animation's name.",
     R"(print(Animation.GetName(animation))  --> stand_run_forward_aim)"},
    {"Animation.GetNormalizedTime", "animation: Animation", "number",
     "The current position in the animation: 0 at the start, 1 at the end.",
     R"(print(Animation.GetNormalizedTime(animation))  --> 0)"},
    {"Animation.GetTime", "animation: Animation", "number [s]", "The current time in the animation.",
     R"(print(Animation.GetTime(animation))  --> 0)"},
    {"Animation.GetWeight", "animation: Animation", "number", "The animation's weight among the enabled animations.",
     R"(print(Animation.GetWeight(animation))  --> 1)"},
    {"Animation.IsEnabled", "animation: Animation", "boolean", "Whether the animation is switched on.",
     R"(print(Animation.IsEnabled(animation))  --> false)"},
    {"Animation.IsLooping", "animation: Animation", "boolean", "Whether the animation starts again at its end.",
     R"(print(Animation.IsLooping(animation))  --> true)"},
    {"Animation.Play",
     "mesh: Scene, name: string, looping: boolean = true, speed: number -100..100 = 1, blend: number 0..10 [s] = 0.2",
     "Animation",
     "Plays one of the mesh's animations. The world then advances it, and the script need not step it. Other "
     "animations that this function has started fade out. The animation starts at its beginning, or at its end if the "
     "speed is negative; if it plays already, it continues with the new arguments. If it does not loop, the mesh keeps "
     "its last pose until Animation.Stop or the next Animation.Play. An unknown name is an error.",
     R"(local run = Animation.Play(mesh, "stand_run_forward_aim", true, 1.5)
print(Animation.GetName(run), Animation.IsEnabled(run))  --> stand_run_forward_aim	true)",
     true},
    {"Animation.Reset", "animation: Animation", "", "Returns to the start.", R"(Animation.Reset(animation))"},
    {"Animation.SetDisplaySkeleton", "mesh: Scene, show: boolean", "", "Shows or hides the bones over the mesh.",
     R"(Animation.SetDisplaySkeleton(mesh, true))"},
    {"Animation.SetEnabled", "animation: Animation, enabled: boolean", "", "Switches the animation on or off.",
     R"(Animation.SetEnabled(animation, true)
print(Animation.IsEnabled(animation))  --> true)"},
    {"Animation.SetLocomotion", "mesh: Scene, walks: boolean, style: string = ready", "",
     "If walks is true, a soldier mesh walks, runs, turns and falls automatically, as its agent moves. The style is "
     "ready, aim, crouch or unarmed (with empty hands). Animations that scripts enable take precedence; the legs keep "
     "walking while the soldier shoots or reloads.",
     R"(Animation.SetLocomotion(mesh, true, "aim"))", true},
    {"Animation.SetLooping", "animation: Animation, looping: boolean", "",
     "Sets whether the animation starts again at its end or stays there.", R"(Animation.SetLooping(animation, false))"},
    {"Animation.SetNormalizedTime", "animation: Animation, time: number 0..1", "",
     "Sets the position in the animation, from 0 (the start) to 1 (the end).",
     R"(Animation.SetNormalizedTime(animation, 0.5)
print(Animation.GetNormalizedTime(animation))  --> 0.5)"},
    {"Animation.SetTime", "animation: Animation, time: number [s]", "",
     "Sets the time in the animation. It wraps around if the animation loops; otherwise it stays between start and "
     "end.",
     R"(Animation.SetTime(animation, 0.2))"},
    {"Animation.SetWeight", "animation: Animation, weight: number", "",
     "Sets the animation's weight among the enabled animations. If the sum of all weights is above 1, they are scaled "
     "down.",
     R"(Animation.SetWeight(animation, 0.25)
print(Animation.GetWeight(animation))  --> 0.25)"},
    {"Animation.StepAnimation", "animation: Animation, delta: number [ms]", "",
     "Advances the animation by this time. Animations that Animation.Play has started advance without it.",
     R"(Animation.SetEnabled(animation, true)
Animation.StepAnimation(animation, 33))"},
    {"Animation.Stop", "mesh: Scene, blend: number 0..10 [s] = 0.2", "",
     "Fades out the animations that Animation.Play has started. The mesh then has the pose of its file, or walks "
     "(Animation.SetLocomotion).",
     R"(Animation.Play(mesh, "stand_run_forward_aim")
Animation.Stop(mesh, 0))",
     true},
};

}  // namespace

std::span<const ApiFunction> AnimationApi() {
  return kAnimationFunctions;
}

}  // namespace soarbox::script
