// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "diagnostics/plain_text.h"
#include "script/api_call.h"
#include "script/argument_check.h"
#include "world/animation/animator.h"

// Animation: the animations of a body with a skeleton, and their playback (lua_api.md 5.5).

namespace soarbox::script {
namespace {

using world::Animator;
using enum WrongCount;
using Animation = world::Scene::FoundAnimation;

const world::AnimationState& StateOf(const Animation& animation) {
  return animation.animator->state(animation.clip);
}

const world::Clip& ClipOf(const Animation& animation) {
  return animation.animator->rig().clips[animation.clip];
}

/// Describes an unknown name: a similar name, and all names if they are few.
void PushUnknownName(lua_State* state, std::string_view name, const world::Rig& rig) {
  constexpr std::size_t kFew = 20, kMostShown = 60;
  const std::vector<std::string_view> known = rig.ClipNames();
  std::string text = "there is no animation \"" + std::string(Beginning(name, kMostShown)) + "\" here";
  const std::string_view meant = Suggest(name, known);
  if (!meant.empty()) text += "; did you mean \"" + std::string(meant) + "\"?";
  if (known.empty()) text += "; the mesh has none";
  if (!known.empty() && (meant.empty() || known.size() <= kFew)) {
    text += meant.empty() ? "; there are " : " There are ";
    for (std::size_t i = 0; i < known.size(); ++i) text += (i == 0 ? "" : ", ") + std::string(known[i]);
  }
  lua_pushlstring(state, text.data(), text.size());
}

/// The clip of the mesh with this name, which is argument 2; raises an error for unknown names.
std::size_t ClipArgument(lua_State* state, const Body& mesh, std::string_view name) {
  const int clip = mesh.animator.rig().FindClip(name);
  if (clip >= 0) return static_cast<std::size_t>(clip);
  PushUnknownName(state, name, mesh.animator.rig());
  ArgumentError(state, 2, lua_tostring(state, -1));
  return 0;
}

Handle HandleOf(world::Scene& scene, const Body& mesh, std::size_t clip) {
  return {ValueKind::kAnimation, Number(scene.AnimationOf(mesh.node, clip))};
}

Handle GetAnimation(lua_State* state, world::Scene& scene, const Body& mesh, std::string_view name) {
  return HandleOf(scene, mesh, ClipArgument(state, mesh, name));
}

std::vector<std::string_view> GetAnimationNames(const Body& mesh) {
  return mesh.animator.rig().ClipNames();
}

constexpr float kBlend_s = 0.2f;

Handle Play(lua_State* state, world::Scene& scene, const Body& mesh, std::string_view name, std::optional<bool> loops,
            std::optional<float> speed, std::optional<float> blend_s) {
  const std::size_t clip = ClipArgument(state, mesh, name);
  mesh.animator.Play(clip, loops.value_or(true), speed.value_or(1), blend_s.value_or(kBlend_s));
  return HandleOf(scene, mesh, clip);
}

void Stop(const Body& mesh, std::optional<float> blend_s) {
  mesh.animator.Play({}, true, 1, blend_s.value_or(kBlend_s));
}

float GetLength(const Animation& animation) {
  return ClipOf(animation).length_s();
}

std::string_view GetName(const Animation& animation) {
  return ClipOf(animation).name();
}

float GetTime(const Animation& animation) {
  return StateOf(animation).time_s;
}

float GetNormalizedTime(const Animation& animation) {
  return StateOf(animation).time_s / ClipOf(animation).length_s();
}

float GetWeight(const Animation& animation) {
  return StateOf(animation).weight;
}

bool IsEnabled(const Animation& animation) {
  return StateOf(animation).enabled;
}

bool IsLooping(const Animation& animation) {
  return StateOf(animation).looping;
}

/// `kSet`: the function of Animator.
template <auto kSet, class Value>
void Set(const Animation& animation, Value value) {
  (animation.animator->*kSet)(animation.clip, value);
}

void SetNormalizedTime(const Animation& animation, float share) {
  animation.animator->SetTime(animation.clip, share * ClipOf(animation).length_s());
}

void Reset(const Animation& animation) {
  animation.animator->SetTime(animation.clip, 0);
}

void StepAnimation(const Animation& animation, float millis) {
  animation.animator->SetTime(animation.clip, StateOf(animation).time_s + millis / 1000);
}

constexpr ApiFunction kAnimationFunctions[] = {
    {"Animation.GetAnimation", kCall<GetAnimation>, kError, "mesh: Mesh, name: string", "Animation",
     "One of the mesh's animations. Initially it is disabled and looping, has weight 1, and is at its start.",
     R"(local idle = Animation.GetAnimation(mesh, "stand_idle_aim")
Animation.SetEnabled(idle, true))"},
    {"Animation.GetAnimationNames", kCall<GetAnimationNames>, kError, "mesh: Mesh", "table of string",
     "The names of the mesh's animations, counted from 1.",
     R"(for _, name in ipairs(Animation.GetAnimationNames(mesh)) do assert(Animation.GetAnimation(mesh, name)) end)",
     true},
    {"Animation.GetLength", kCall<GetLength>, kIgnored, "animation: Animation", "number [s]",
     "The length of the animation.", R"(print(Animation.GetLength(animation) > 0)  --> true)"},
    {"Animation.GetName", kCall<GetName>, kIgnored, "animation: Animation", "string", "The animation's name.",
     R"(print(Animation.GetName(animation))  --> stand_run_forward_aim)"},
    {"Animation.GetNormalizedTime", kCall<GetNormalizedTime>, kIgnored, "animation: Animation", "number",
     "The current position in the animation: 0 at the start, 1 at the end.",
     R"(print(Animation.GetNormalizedTime(animation))  --> 0)"},
    {"Animation.GetTime", kCall<GetTime>, kIgnored, "animation: Animation", "number [s]",
     "The current time in the animation.", R"(print(Animation.GetTime(animation))  --> 0)"},
    {"Animation.GetWeight", kCall<GetWeight>, kIgnored, "animation: Animation", "number",
     "The animation's weight among the enabled animations.", R"(print(Animation.GetWeight(animation))  --> 1)"},
    {"Animation.IsEnabled", kCall<IsEnabled>, kIgnored, "animation: Animation", "boolean",
     "Whether the animation is switched on.", R"(print(Animation.IsEnabled(animation))  --> false)"},
    {"Animation.IsLooping", kCall<IsLooping>, kIgnored, "animation: Animation", "boolean",
     "Whether the animation starts again at its end.", R"(print(Animation.IsLooping(animation))  --> true)"},
    {"Animation.Play", kCall<Play>, kError,
     "mesh: Mesh, name: string, looping: boolean = true, speed: number -100..100 = 1, blend: number 0..10 [s] = 0.2",
     "Animation",
     "Plays one of the mesh's animations. The world then advances it, and the script need not step it. Other "
     "animations that this function has started fade out. The animation starts at its beginning, or at its end if the "
     "speed is negative; if it plays already, it continues with the new arguments. If it does not loop, the mesh keeps "
     "its last pose until Animation.Stop or the next Animation.Play. An unknown name is an error.",
     R"(local run = Animation.Play(mesh, "stand_run_forward_aim", true, 1.5)
print(Animation.GetName(run), Animation.IsEnabled(run))  --> stand_run_forward_aim	true)",
     true},
    {"Animation.Reset", kCall<Reset>, kIgnored, "animation: Animation", "", "Returns to the start.",
     R"(Animation.Reset(animation))"},
    {"Animation.SetEnabled", kCall<Set<&Animator::SetEnabled, bool>>, kIgnored,
     "animation: Animation, enabled: boolean", "", "Switches the animation on or off.",
     R"(Animation.SetEnabled(animation, true)
print(Animation.IsEnabled(animation))  --> true)"},
    {"Animation.SetLooping", kCall<Set<&Animator::SetLooping, bool>>, kIgnored,
     "animation: Animation, looping: boolean", "", "Sets whether the animation starts again at its end or stays there.",
     R"(Animation.SetLooping(animation, false))"},
    {"Animation.SetNormalizedTime", kCall<SetNormalizedTime>, kIgnored, "animation: Animation, time: number 0..1", "",
     "Sets the position in the animation, from 0 (the start) to 1 (the end).",
     R"(Animation.SetNormalizedTime(animation, 0.5)
print(Animation.GetNormalizedTime(animation))  --> 0.5)"},
    {"Animation.SetTime", kCall<Set<&Animator::SetTime, float>>, kIgnored, "animation: Animation, time: number [s]", "",
     "Sets the time in the animation. It wraps around if the animation loops; otherwise it stays between start and "
     "end.",
     R"(Animation.SetTime(animation, 0.2))"},
    {"Animation.SetWeight", kCall<Set<&Animator::SetWeight, float>>, kIgnored, "animation: Animation, weight: number",
     "",
     "Sets the animation's weight among the enabled animations. If the sum of all weights is above 1, they are scaled "
     "down.",
     R"(Animation.SetWeight(animation, 0.25)
print(Animation.GetWeight(animation))  --> 0.25)"},
    {"Animation.StepAnimation", kCall<StepAnimation>, kIgnored, "animation: Animation, delta: number [ms]", "",
     "Advances the animation by this time. Animations that Animation.Play has started advance without it.",
     R"(Animation.SetEnabled(animation, true)
Animation.StepAnimation(animation, 33))"},
    {"Animation.Stop", kCall<Stop>, kIgnored, "mesh: Mesh, blend: number 0..10 [s] = 0.2", "",
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
