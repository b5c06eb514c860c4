// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <array>
#include <lua.hpp>
#include <string>

#include "diagnostics/diagnostic.h"
#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "world/animation/animator.h"
#include "world/rotation.h"

// Animation: the bones of a body, attachments, and locomotion (lua_api.md 5.5).

namespace soarbox::script {
namespace {

using world::NodeId;

/// Warns that a bone does not exist and suggests a similar name; for calls that then return nothing.
void WarnOfBone(lua_State* state, std::string_view bone, const std::vector<std::string_view>& known) {
  std::string text = "there is no bone \"" + std::string(bone) + "\"";
  const std::string_view meant = Suggest(bone, known);
  if (!meant.empty()) text += "; did you mean \"" + std::string(meant) + "\"?";
  WarnIgnored(state, text.c_str());
}

/// Returns nothing, after a warning, if the body has no such bone.
std::optional<world::BonePose> BoneArgument(lua_State* state) {
  const std::string_view bone = TextArgument(state, 2);
  const NodeId body = BodyArgument(state, 1);
  if (body == NodeId::kNone) return std::nullopt;
  const world::Scene& scene = ContextOf(state).world.scene();
  const std::optional<world::BonePose> pose = scene.BoneInWorld(body, bone);
  if (!pose) WarnOfBone(state, bone, scene.BonesBelow(body));
  return pose;
}

int GetBonePosition(lua_State* state) {
  const auto pose = BoneArgument(state);
  if (!pose) return 0;
  PushVector(state, pose->position);
  return 1;
}

int GetBoneRotation(lua_State* state) {
  const auto pose = BoneArgument(state);
  if (!pose) return 0;
  PushVector(state, world::ToRotationVector(pose->orientation));
  return 1;
}

/// The table's first index is 0, as in the original sandbox.
int GetBoneNames(lua_State* state) {
  const Handle* handle = ToHandle(state, 1);
  if (handle && handle->kind == ValueKind::kAgent) return ArgumentError(state, 1, "a mesh expected, got an agent");
  const NodeId node = NodeArgument(state, 1, false);
  lua_newtable(state);
  const world::Animator* animator = node == NodeId::kNone ? nullptr : ContextOf(state).world.scene().AnimatorOf(node);
  if (!animator) return 1;
  int index = 0;
  for (const std::string_view name : animator->rig().BoneNames()) {
    lua_pushlstring(state, name.data(), name.size());
    lua_rawseti(state, -2, index++);
  }
  return 1;
}

int AttachToBone(lua_State* state) {
  const std::string_view bone = TextArgument(state, 2);
  const world::Vec3 offset = lua_gettop(state) >= 4 ? CheckVector(state, 4) : world::Vec3{};
  const world::Vec3 turn_deg = lua_gettop(state) >= 5 ? CheckVector(state, 5) : world::Vec3{};
  const NodeId body = BodyArgument(state, 1);
  const Handle* other = ToHandle(state, 3);
  if (!other || other->kind != ValueKind::kNode)
    return ArgumentError(
        state, 3, "a scene node expected, such as one of Core.CreateMesh: things with a body cannot be attached");
  const NodeId thing = NodeArgument(state, 3, false);
  if (body == NodeId::kNone || thing == NodeId::kNone) return 0;
  world::Scene& scene = ContextOf(state).world.scene();
  const world::Skeleton& skeleton = scene.AnimatorOf(body)->rig().skeleton;
  const int index = skeleton.Find(bone);
  if (index < 0) {
    WarnOfBone(state, bone, scene.AnimatorOf(body)->rig().BoneNames());
    return 0;
  }
  // The function visits everything attached to the node.
  LuaMachine::Of(state).Charge(scene.node_count() / 10);
  const bool hangs =
      scene.AttachToBone(body, static_cast<std::size_t>(index), thing, offset, world::FromRotationVector(turn_deg));
  if (!hangs) WarnIgnored(state, "the mesh is itself attached to this node, or the nodes would be nested too deep");
  return 0;
}

int SetDisplaySkeleton(lua_State* state) {
  const NodeId body = BodyArgument(state, 1);
  if (body != NodeId::kNone)
    ContextOf(state).world.scene().AnimatorOf(body)->set_shows_skeleton(TruthArgument(state, 2));
  return 0;
}

/// An extension: the body walks, runs, turns and falls with its agent. Style: "ready", "aim", "crouch" or "unarmed".
int SetLocomotion(lua_State* state) {
  static constexpr std::array<std::string_view, world::kLocomotionStyles> kStyles{"ready", "aim", "crouch", "unarmed"};
  const std::string_view wanted = lua_isnoneornil(state, 3) ? kStyles[0] : TextArgument(state, 3);
  const auto found = std::find(kStyles.begin(), kStyles.end(), wanted);
  if (found == kStyles.end()) return ArgumentError(state, 3, "a style is ready, aim, crouch or unarmed");
  const auto style = static_cast<world::LocomotionStyle>(found - kStyles.begin());
  const NodeId body = BodyArgument(state, 1);
  if (body == NodeId::kNone) return 0;
  world::Animator& animator = *ContextOf(state).world.scene().AnimatorOf(body);
  const bool walks = TruthArgument(state, 2);
  animator.SetLocomotion(walks, style);
  if (walks && !animator.has_locomotion()) WarnIgnored(state, "this mesh has no legs to walk with");
  return 0;
}

constexpr Binding kAnimationBonesBindings[] = {
    {"AttachToBone", AttachToBone, 3, 5, WrongCount::kIgnored},
    {"GetBoneNames", GetBoneNames, 1, 1, WrongCount::kIgnored},
    {"GetBonePosition", GetBonePosition, 2, 2, WrongCount::kIgnored},
    {"GetBoneRotation", GetBoneRotation, 2, 2, WrongCount::kIgnored},
    {"SetDisplaySkeleton", SetDisplaySkeleton, 2, 2, WrongCount::kIgnored},
    {"SetLocomotion", SetLocomotion, 2, 3, WrongCount::kIgnored},
};

}  // namespace

void BindAnimationBones(lua_State* state) {
  RegisterTable(state, "Animation", kAnimationBonesBindings);
}

}  // namespace soarbox::script
