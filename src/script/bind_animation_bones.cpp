// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <array>
#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "script/api_call.h"
#include "script/argument_check.h"
#include "world/animation/animator.h"
#include "world/rotation.h"

// Animation: the bones of a body, attachments, and locomotion (lua_api.md 5.5).

namespace soarbox::script {
namespace {

using world::NodeId;
using world::Scene;
using world::Vec3;
using enum WrongCount;

/// Warns that a bone does not exist and suggests a similar name; for calls that then return nothing.
void WarnOfBone(lua_State* state, std::string_view bone, const std::vector<std::string_view>& known) {
  std::string text = "there is no bone \"" + std::string(bone) + "\"";
  const std::string_view meant = Suggest(bone, known);
  if (!meant.empty()) text += "; did you mean \"" + std::string(meant) + "\"?";
  WarnIgnored(state, text.c_str());
}

/// Returns nothing, after a warning, if the mesh has no such bone.
std::optional<world::BonePose> PoseOf(lua_State* state, const Scene& scene, const Body& mesh, std::string_view bone) {
  const std::optional<world::BonePose> pose = scene.BoneInWorld(mesh.node, bone);
  if (!pose) WarnOfBone(state, bone, scene.BonesBelow(mesh.node));
  return pose;
}

std::optional<Vec3> GetBonePosition(lua_State* state, const Scene& scene, const Body& mesh, std::string_view bone) {
  const auto pose = PoseOf(state, scene, mesh, bone);
  return pose ? std::optional(pose->position) : std::nullopt;
}

std::optional<Vec3> GetBoneRotation(lua_State* state, const Scene& scene, const Body& mesh, std::string_view bone) {
  const auto pose = PoseOf(state, scene, mesh, bone);
  return pose ? std::optional(world::ToRotationVector(pose->orientation)) : std::nullopt;
}

/// The table's first index is 0, as in the original sandbox. Empty without a skeleton.
int GetBoneNames(lua_State* state) {
  const Handle* handle = ToHandle(state, 1);
  if (handle && handle->kind == ValueKind::kAgent) return ArgumentError(state, 1, "a mesh expected, got an agent");
  const world::Animator* animator = ContextOf(state).world.scene().AnimatorOf(NodeArgument(state, 1));
  std::vector<std::string_view> names;
  if (animator) names = animator->rig().BoneNames();
  return PushResult(state, std::span<const std::string_view>(names), 0);
}

/// (mesh, bone, node [, offset [, rotation]])
void AttachToBone(lua_State* state, Scene& scene, const Body& mesh, std::string_view bone) {
  int next = 4;
  const Vec3 offset = ReadParameter<std::optional<Vec3>>(state, next).value_or(Vec3{});
  const Vec3 turn_deg = ReadParameter<std::optional<Vec3>>(state, next).value_or(Vec3{});
  if (ToHandle(state, 3)->kind != ValueKind::kNode)
    ArgumentError(state, 3,
                  "a scene node expected, such as one of Core.CreateMesh: things with a body cannot be attached");
  const NodeId thing = NodeArgument(state, 3);
  const world::Rig& rig = mesh.animator.rig();
  const int index = rig.skeleton.Find(bone);
  if (index < 0) {
    WarnOfBone(state, bone, rig.BoneNames());
    return;
  }
  // The function visits everything attached to the node.
  LuaMachine::Of(state).Charge(scene.node_count() / 10);
  const bool hangs = scene.AttachToBone(mesh.node, static_cast<std::size_t>(index), thing, offset,
                                        world::FromRotationVector(turn_deg));
  if (!hangs) WarnIgnored(state, "the mesh is itself attached to this node, or the nodes would be nested too deep");
}

void SetDisplaySkeleton(const Body& mesh, bool shows) {
  mesh.animator.set_shows_skeleton(shows);
}

/// An extension: the body walks, runs, turns and falls with its agent. Style: "ready", "aim", "crouch" or "unarmed".
void SetLocomotion(lua_State* state, const Body& mesh, bool walks, std::optional<std::string_view> wanted) {
  static constexpr std::array<std::string_view, world::kLocomotionStyles> kStyles{"ready", "aim", "crouch", "unarmed"};
  const auto* const found = std::find(kStyles.begin(), kStyles.end(), wanted.value_or(kStyles[0]));
  if (found == kStyles.end()) ArgumentError(state, 3, "a style is ready, aim, crouch or unarmed");
  mesh.animator.SetLocomotion(walks, static_cast<world::LocomotionStyle>(found - kStyles.begin()));
  if (walks && !mesh.animator.has_locomotion()) WarnIgnored(state, "this mesh has no legs to walk with");
}

constexpr ApiFunction kAnimationBonesFunctions[] = {
    {"Animation.AttachToBone", kCall<AttachToBone>, kIgnored,
     "mesh: Mesh, bone: string, other: Node, offset: Vector [m] = none, rotation: Vector [deg] = none", "",
     "Attaches a node to a bone. The node then moves with the bone, and its position and rotation are relative to the "
     "bone.",
     R"(local hat = Core.CreateBox(sandbox, 0.2, 0.1, 0.2)
Animation.AttachToBone(mesh, "b_Head1", hat, Vector.new(0, 0.2, 0)))"},
    {"Animation.GetBoneNames", GetBoneNames, kIgnored, "mesh: Mesh", "table of string",
     "The names of the bones, counted from 0; {} without bones.",
     R"(print(Animation.GetBoneNames(mesh)[0] ~= nil)  --> true)"},
    {"Animation.GetBonePosition", kCall<GetBonePosition>, kIgnored, "mesh: Mesh, bone: string", "Vector [m]",
     "The position of a bone in the world. Bones of attached meshes are found, too. Nothing for other names.",
     R"(print(Animation.GetBonePosition(mesh, "b_Head1").y > 1)  --> true)"},
    {"Animation.GetBoneRotation", kCall<GetBoneRotation>, kIgnored, "mesh: Mesh, bone: string", "Vector [deg]",
     "The rotation of a bone in the world.", R"(local turn = Animation.GetBoneRotation(mesh, "b_Head1"))"},
    {"Animation.SetDisplaySkeleton", kCall<SetDisplaySkeleton>, kIgnored, "mesh: Mesh, show: boolean", "",
     "Shows or hides the bones over the mesh.", R"(Animation.SetDisplaySkeleton(mesh, true))"},
    {"Animation.SetLocomotion", kCall<SetLocomotion>, kIgnored, "mesh: Mesh, walks: boolean, style: string = ready", "",
     "If walks is true, a soldier mesh walks, runs, turns and falls automatically, as its agent moves. The style is "
     "ready, aim, crouch or unarmed (with empty hands). Animations that scripts enable take precedence; the legs keep "
     "walking while the soldier shoots or reloads.",
     R"(Animation.SetLocomotion(mesh, true, "aim"))", true},
};

}  // namespace

std::span<const ApiFunction> AnimationBonesApi() {
  return kAnimationBonesFunctions;
}

}  // namespace soarbox::script
