// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>
#include <string>

#include "diagnostics/diagnostic.h"
#include "diagnostics/plain_text.h"
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

/// Pushes what is wrong with the name in argument 2: a similar name, and all names if they are few.
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

/// The animation of the mesh in argument 1 that argument 2 names. Its animator is null, after a warning, if argument 1
/// is no mesh.
world::Scene::FoundAnimation NamedArgument(lua_State* state, NodeId& body) {
  const std::string_view name = TextArgument(state, 2);
  body = BodyArgument(state, 1);
  if (body == NodeId::kNone) return {};
  world::Animator* const animator = ContextOf(state).world.scene().AnimatorOf(body);
  const int clip = animator->rig().FindClip(name);
  if (clip >= 0) return {animator, static_cast<std::size_t>(clip)};
  PushUnknownName(state, name, animator->rig());
  ArgumentError(state, 2, lua_tostring(state, -1));
  return {};
}

int PushAnimation(lua_State* state, NodeId body, std::size_t clip) {
  PushHandle(state, {ValueKind::kAnimation, Number(ContextOf(state).world.scene().AnimationOf(body, clip))});
  return 1;
}

int GetAnimation(lua_State* state) {
  NodeId body{};
  const auto found = NamedArgument(state, body);
  return found.animator ? PushAnimation(state, body, found.clip) : 0;
}

/// Counted from 1.
int GetAnimationNames(lua_State* state) {
  const NodeId body = BodyArgument(state, 1);
  lua_newtable(state);
  if (body == NodeId::kNone) return 1;
  int index = 0;
  for (const std::string_view name : ContextOf(state).world.scene().AnimatorOf(body)->rig().ClipNames()) {
    lua_pushlstring(state, name.data(), name.size());
    lua_rawseti(state, -2, ++index);
  }
  return 1;
}

/// Reads an optional number.
float NumberOr(lua_State* state, int index, float otherwise) {
  return lua_isnoneornil(state, index) ? otherwise : CheckFloat(state, index);
}
constexpr float kBlend_s = 0.2f;

int Play(lua_State* state) {
  const bool loops = lua_isnoneornil(state, 3) || TruthArgument(state, 3);
  const float speed = NumberOr(state, 4, 1), blend_s = NumberOr(state, 5, kBlend_s);
  NodeId body{};
  const auto found = NamedArgument(state, body);
  if (!found.animator || !world::IsFinite(speed) || !world::IsFinite(blend_s)) return 0;
  found.animator->Play(found.clip, loops, speed, blend_s);
  return PushAnimation(state, body, found.clip);
}

int Stop(lua_State* state) {
  const float blend_s = NumberOr(state, 2, kBlend_s);
  const NodeId body = BodyArgument(state, 1);
  if (body != NodeId::kNone && world::IsFinite(blend_s))
    ContextOf(state).world.scene().AnimatorOf(body)->Play({}, true, 1, blend_s);
  return 0;
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
  if (FiniteArgument(state, millis))
    found.animator->SetTime(found.clip, found.animator->state(found.clip).time_s + millis / 1000);
  return 0;
}

constexpr Binding kAnimationBindings[] = {
    {"GetAnimation", GetAnimation, 2, 2, WrongCount::kError},
    {"GetAnimationNames", GetAnimationNames, 1, 1, WrongCount::kError},
    {"GetLength", GetLength, 1, 1, WrongCount::kIgnored},
    {"GetName", GetName, 1, 1, WrongCount::kIgnored},
    {"GetNormalizedTime", GetNormalizedTime, 1, 1, WrongCount::kIgnored},
    {"GetTime", GetTime, 1, 1, WrongCount::kIgnored},
    {"GetWeight", GetWeight, 1, 1, WrongCount::kIgnored},
    {"IsEnabled", IsEnabled, 1, 1, WrongCount::kIgnored},
    {"IsLooping", IsLooping, 1, 1, WrongCount::kIgnored},
    {"Play", Play, 2, 5, WrongCount::kError},
    {"Reset", Reset, 1, 1, WrongCount::kIgnored},
    {"SetEnabled", SetEnabled, 2, 2, WrongCount::kIgnored},
    {"SetLooping", SetLooping, 2, 2, WrongCount::kIgnored},
    {"SetNormalizedTime", SetNormalizedTime, 2, 2, WrongCount::kIgnored},
    {"SetTime", SetTime, 2, 2, WrongCount::kIgnored},
    {"SetWeight", SetWeight, 2, 2, WrongCount::kIgnored},
    {"StepAnimation", StepAnimation, 2, 2, WrongCount::kIgnored},
    {"Stop", Stop, 1, 2, WrongCount::kIgnored},
};

}  // namespace

void BindAnimation(lua_State* state) {
  RegisterTable(state, "Animation", kAnimationBindings);
}

}  // namespace soarbox::script
