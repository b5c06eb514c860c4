// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>
#include <string>

#include "diagnostics/diagnostic.h"
#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "world/animation/animator.h"

// Animation: the animations of a body with a skeleton, and their playback (lua_api.md 5.5).

namespace soarbox::script {
namespace {

using world::Animator;
using world::NodeId;

/// Returns an existing animation; raises an error for a removed one.
world::Scene::FoundAnimation AnimationArgument(lua_State* state) {
  const world::AnimationId id{CheckHandle(state, 1, ValueKind::kAnimation)};
  const auto found = ContextOf(state).world.scene().FindAnimation(id);
  if (!found.animator) ArgumentError(state, 1, "the mesh of this animation was removed");
  return found;
}

const world::AnimationState& StateArgument(lua_State* state) {
  const auto found = AnimationArgument(state);
  return found.animator->state(found.clip);
}

const world::Clip& ClipArgument(lua_State* state) {
  const auto found = AnimationArgument(state);
  return found.animator->rig().clips[found.clip];
}

/// Reads a finite number; false after a warning.
bool FiniteArgument(lua_State* state, float& number) {
  number = CheckFloat(state, 2);
  const bool finite = world::IsFinite(number);
  WarnUnless(state, finite);
  return finite;
}

int GetAnimation(lua_State* state) {
  const std::string_view name = TextArgument(state, 2);
  const NodeId body = BodyArgument(state, 1);
  if (body == NodeId::kNone) return 0;
  world::Scene& scene = ContextOf(state).world.scene();
  const world::Rig& rig = scene.AnimatorOf(body)->rig();
  const int clip = rig.FindClip(name);
  if (clip < 0) {
    const std::string_view meant = Suggest(name, rig.ClipNames());
    lua_pushfstring(state, "there is no animation \"%s\" here", lua_tostring(state, 2));
    if (!meant.empty()) {
      lua_pushliteral(state, "; did you mean \"");
      lua_pushlstring(state, meant.data(), meant.size());
      lua_pushliteral(state, "\"?");
      lua_concat(state, 4);
    }
    return ArgumentError(state, 2, lua_tostring(state, -1));
  }
  PushHandle(state, {ValueKind::kAnimation, Number(scene.AnimationOf(body, static_cast<std::size_t>(clip)))});
  return 1;
}

int GetLength(lua_State* state) {
  lua_pushnumber(state, ClipArgument(state).length_s());
  return 1;
}

int GetName(lua_State* state) {
  const std::string& name = ClipArgument(state).name();
  lua_pushlstring(state, name.data(), name.size());
  return 1;
}

int GetTime(lua_State* state) {
  lua_pushnumber(state, StateArgument(state).time_s);
  return 1;
}

/// Passes a number to set(animator, clip, number), unless it is not finite.
template <class Set>
int SetFinite(lua_State* state, Set set) {
  const auto found = AnimationArgument(state);
  float value = 0;
  if (FiniteArgument(state, value)) set(*found.animator, found.clip, value);
  return 0;
}

int SetTime(lua_State* state) {
  return SetFinite(state, [](auto& animator, auto clip, float time_s) { animator.SetTime(clip, time_s); });
}

int GetNormalizedTime(lua_State* state) {
  lua_pushnumber(state, StateArgument(state).time_s / ClipArgument(state).length_s());
  return 1;
}

int SetNormalizedTime(lua_State* state) {
  return SetFinite(state, [state](auto& animator, auto clip, float share) {
    animator.SetTime(clip, std::clamp(share, 0.0f, 1.0f) * ClipArgument(state).length_s());
  });
}

int GetWeight(lua_State* state) {
  lua_pushnumber(state, StateArgument(state).weight);
  return 1;
}

int SetWeight(lua_State* state) {
  return SetFinite(state, [](auto& animator, auto clip, float weight) { animator.SetWeight(clip, weight); });
}

int IsEnabled(lua_State* state) {
  lua_pushboolean(state, StateArgument(state).enabled);
  return 1;
}

int SetEnabled(lua_State* state) {
  const auto found = AnimationArgument(state);
  found.animator->SetEnabled(found.clip, TruthArgument(state, 2));
  return 0;
}

int IsLooping(lua_State* state) {
  lua_pushboolean(state, StateArgument(state).looping);
  return 1;
}

int SetLooping(lua_State* state) {
  const auto found = AnimationArgument(state);
  found.animator->SetLooping(found.clip, TruthArgument(state, 2));
  return 0;
}

int Reset(lua_State* state) {
  const auto found = AnimationArgument(state);
  found.animator->SetTime(found.clip, 0);
  return 0;
}

int StepAnimation(lua_State* state) {
  const auto found = AnimationArgument(state);
  float millis = 0;
  if (FiniteArgument(state, millis)) found.animator->Step(found.clip, millis / 1000);
  return 0;
}

constexpr Binding kAnimationBindings[] = {
    {"GetAnimation", GetAnimation, 2, 2, WrongCount::kError},
    {"GetLength", GetLength, 1, 1, WrongCount::kIgnored},
    {"GetName", GetName, 1, 1, WrongCount::kIgnored},
    {"GetNormalizedTime", GetNormalizedTime, 1, 1, WrongCount::kIgnored},
    {"GetTime", GetTime, 1, 1, WrongCount::kIgnored},
    {"GetWeight", GetWeight, 1, 1, WrongCount::kIgnored},
    {"IsEnabled", IsEnabled, 1, 1, WrongCount::kIgnored},
    {"IsLooping", IsLooping, 1, 1, WrongCount::kIgnored},
    {"Reset", Reset, 1, 1, WrongCount::kIgnored},
    {"SetEnabled", SetEnabled, 2, 2, WrongCount::kIgnored},
    {"SetLooping", SetLooping, 2, 2, WrongCount::kIgnored},
    {"SetNormalizedTime", SetNormalizedTime, 2, 2, WrongCount::kIgnored},
    {"SetTime", SetTime, 2, 2, WrongCount::kIgnored},
    {"SetWeight", SetWeight, 2, 2, WrongCount::kIgnored},
    {"StepAnimation", StepAnimation, 2, 2, WrongCount::kIgnored},
};

}  // namespace

void BindAnimation(lua_State* state) {
  RegisterTable(state, "Animation", kAnimationBindings);
}

}  // namespace soarbox::script
