// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

namespace soarbox::script {
namespace {

constexpr ApiFunction kFunctions[] = {
    {"Animation.AttachToBone",
     "mesh: Scene, bone: string, other: Node, offset: Vector [m] = none, rotation: Vector [deg] = none", "",
     "Hangs a node on a bone: it moves with the bone from then on, and its position and rotation are relative to it.",
     R"(local hat = Core.CreateBox(sandbox, 0.2, 0.1, 0.2)
Animation.AttachToBone(mesh, "b_Head1", hat, Vector.new(0, 0.2, 0)))"},
    {"Animation.GetAnimation", "mesh: Scene, name: string", "Animation",
     "One of the mesh's animations: at its start, of weight 1, looping, disabled until it is enabled.",
     R"(local idle = Animation.GetAnimation(mesh, "stand_idle_aim")
Animation.SetEnabled(idle, true))"},
    {"Animation.GetBoneNames", "mesh: Scene", "table of string",
     "The names of the bones, counted from 0; {} without bones.",
     R"(print(Animation.GetBoneNames(mesh)[0] ~= nil)  --> true)"},
    {"Animation.GetBonePosition", "mesh: Scene, bone: string", "Vector [m]",
     "Where a bone is in the world; bones of meshes that hang on this one are found too. Nothing for other names.",
     R"(print(Animation.GetBonePosition(mesh, "b_Head1").y > 1)  --> true)"},
    {"Animation.GetBoneRotation", "mesh: Scene, bone: string", "Vector [deg]", "How a bone is turned in the world.",
     R"(local turn = Animation.GetBoneRotation(mesh, "b_Head1"))"},
    {"Animation.GetLength", "animation: Animation", "number [s]", "How long the animation lasts.",
     R"(print(Animation.GetLength(animation) > 0)  --> true)"},
    {"Animation.GetName", "animation: Animation", "string", "The animation's name.",
     R"(print(Animation.GetName(animation))  --> stand_run_forward_aim)"},
    {"Animation.GetNormalizedTime", "animation: Animation", "number", "How far it is: 0 at the start, 1 at the end.",
     R"(print(Animation.GetNormalizedTime(animation))  --> 0)"},
    {"Animation.GetTime", "animation: Animation", "number [s]", "How far it is.",
     R"(print(Animation.GetTime(animation))  --> 0)"},
    {"Animation.GetWeight", "animation: Animation", "number", "How much it counts beside the other enabled animations.",
     R"(print(Animation.GetWeight(animation))  --> 1)"},
    {"Animation.IsEnabled", "animation: Animation", "boolean", "Whether it moves the mesh.",
     R"(print(Animation.IsEnabled(animation))  --> false)"},
    {"Animation.IsLooping", "animation: Animation", "boolean", "Whether it starts again at its end.",
     R"(print(Animation.IsLooping(animation))  --> true)"},
    {"Animation.Reset", "animation: Animation", "", "Goes back to the start.", R"(Animation.Reset(animation))"},
    {"Animation.SetDisplaySkeleton", "mesh: Scene, show: boolean", "", "Draws the bones over the mesh, or no longer.",
     R"(Animation.SetDisplaySkeleton(mesh, true))"},
    {"Animation.SetEnabled", "animation: Animation, enabled: boolean", "", "Lets it move the mesh, or no longer.",
     R"(Animation.SetEnabled(animation, true)
print(Animation.IsEnabled(animation))  --> true)"},
    {"Animation.SetLocomotion", "mesh: Scene, walks: boolean, style: string = ready", "",
     "Lets a soldier on an agent walk, run, turn and fall by itself as the agent does; the style is ready, aim, "
     "crouch or unarmed (with empty hands). What scripts enable goes before it; shooting and reloading leave the legs "
     "walking.",
     R"(Animation.SetLocomotion(mesh, true, "aim"))", true},
    {"Animation.SetLooping", "animation: Animation, looping: boolean", "",
     "Lets it start again at its end, or stay there.", R"(Animation.SetLooping(animation, false))"},
    {"Animation.SetNormalizedTime", "animation: Animation, time: number 0..1", "",
     "Goes to a place from 0, the start, to 1, the end.",
     R"(Animation.SetNormalizedTime(animation, 0.5)
print(Animation.GetNormalizedTime(animation))  --> 0.5)"},
    {"Animation.SetTime", "animation: Animation, time: number [s]", "",
     "Goes to a time: round and round if it loops, else between start and end.",
     R"(Animation.SetTime(animation, 0.2))"},
    {"Animation.SetWeight", "animation: Animation, weight: number", "",
     "How much it counts; where the sum of all enabled ones is above 1 they share it.",
     R"(Animation.SetWeight(animation, 0.25)
print(Animation.GetWeight(animation))  --> 0.25)"},
    {"Animation.StepAnimation", "animation: Animation, delta: number [ms]", "",
     "Goes on by this time. Nothing else moves animations on.",
     R"(Animation.SetEnabled(animation, true)
Animation.StepAnimation(animation, 33))"},
};

}  // namespace

std::span<const ApiFunction> AnimationApi() {
  return kFunctions;
}

}  // namespace soarbox::script
