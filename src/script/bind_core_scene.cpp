// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "world/rotation.h"

// Core: positions and appearance of scene nodes and objects.

namespace soarbox::script {
namespace {

using world::NodeId;
using world::Vec3;

world::Scene& SceneOf(lua_State* state) {
  return ContextOf(state).world.scene();
}

bool IsObject(lua_State* state, int index) {
  const Handle* handle = ToHandle(state, index);
  return handle && handle->kind == ValueKind::kObject;
}

/// Returns a plain scene node, not the sandbox's root and not an agent; kNone after a warning.
NodeId PlainNode(lua_State* state, int index) {
  const Handle* handle = ToHandle(state, index);
  if (!handle || handle->kind != ValueKind::kNode) {
    WarnIgnored(state,
                lua_pushfstring(state, "argument %d is not a scene node but %s", index, NameOfValue(state, index)));
    return NodeId::kNone;
  }
  return NodeArgument(state, index, false);
}

int CacheResource(lua_State* state) {
  ContextOf(state).world.catalog().CheckResource(TextArgument(state, 1));
  return 0;
}

int GetPosition(lua_State* state) {
  if (IsObject(state, 1)) {
    PushVector(state, ObjectArgument(state, 1)->Position());
    return 1;
  }
  const Handle* handle = ToHandle(state, 1);
  if (handle && handle->kind == ValueKind::kAgent) {
    PushVector(state, AgentArgument(state, 1).Position());
    return 1;
  }
  const NodeId node = PlainNode(state, 1);
  if (node == NodeId::kNone) return 0;
  PushVector(state, SceneOf(state).Position(node));
  return 1;
}

int GetRadius(lua_State* state) {
  if (IsObject(state, 1)) {
    lua_pushnumber(state, ObjectArgument(state, 1)->Radius());
    return 1;
  }
  const Handle* handle = ToHandle(state, 1);
  if (handle && handle->kind == ValueKind::kAgent) {
    lua_pushnumber(state, SceneOf(state).Radius(AgentArgument(state, 1).node()));
    return 1;
  }
  const NodeId node = PlainNode(state, 1);
  if (node == NodeId::kNone) return 0;
  lua_pushnumber(state, SceneOf(state).Radius(node));
  return 1;
}

int GetRotation(lua_State* state) {
  const world::Object* object = ObjectArgument(state, 1);
  if (!object) return 0;
  PushVector(state, world::ToPitchYawRoll(object->Orientation()));
  return 1;
}

int SetPosition(lua_State* state) {
  const Vec3 position = CheckVector(state, 2);
  if (IsObject(state, 1)) {
    WarnUnless(state, ObjectArgument(state, 1)->SetPosition(position));
    return 0;
  }
  const NodeId node = PlainNode(state, 1);
  if (node != NodeId::kNone) WarnUnless(state, SceneOf(state).SetPosition(node, position));
  return 0;
}

void Orient(lua_State* state, world::Quat orientation) {
  if (IsObject(state, 1)) {
    WarnUnless(state, ObjectArgument(state, 1)->SetOrientation(orientation));
    return;
  }
  const NodeId node = PlainNode(state, 1);
  if (node != NodeId::kNone) WarnUnless(state, SceneOf(state).SetOrientation(node, orientation));
}

int SetRotation(lua_State* state) {
  Orient(state, world::FromRotationVector(CheckVector(state, 2)));
  return 0;
}

bool AreAxes(Vec3 x, Vec3 y, Vec3 z) {
  constexpr float kSlack = 0.01f;
  return std::abs(LengthSquared(x) - 1) < kSlack && std::abs(LengthSquared(y) - 1) < kSlack &&
         LengthSquared(Cross(x, y) - z) < kSlack * kSlack;
}

int SetAxis(lua_State* state) {
  const Vec3 x = CheckVector(state, 2), y = CheckVector(state, 3), z = CheckVector(state, 4);
  if (!AreAxes(x, y, z))
    WarnAtCaller(state, "the axes are not perpendicular, of length 1 and right-handed: a similar rotation is used");
  Orient(state, world::FromAxes(x, y, z));
  return 0;
}

int IsVisible(lua_State* state) {
  const NodeId node = NodeArgument(state, 1, false);
  if (node == NodeId::kNone) return 0;
  lua_pushboolean(state, SceneOf(state).IsVisible(node));
  return 1;
}

int SetVisible(lua_State* state) {
  const NodeId node = NodeArgument(state, 1, false);
  if (node != NodeId::kNone) SceneOf(state).SetVisible(node, TruthArgument(state, 2));
  return 0;
}

int SetMaterial(lua_State* state) {
  const std::string_view material = TextArgument(state, 2);
  const NodeId node = NodeArgument(state, 1, false);
  if (node != NodeId::kNone && !SceneOf(state).SetMaterial(node, material))
    WarnIgnored(state, "nothing that can have a material is attached to this node");
  return 0;
}

int Remove(lua_State* state) {
  if (IsObject(state, 1)) return luaL_error(state, "Core.Remove is for scene nodes; use Sandbox.RemoveObject");
  const NodeId node = PlainNode(state, 1);
  if (node != NodeId::kNone) SceneOf(state).Remove(node);
  return 0;
}

int SetLineStartEnd(lua_State* state) {
  const Vec3 from = CheckVector(state, 2), to = CheckVector(state, 3);
  const NodeId node = NodeArgument(state, 1, true);
  if (node != NodeId::kNone && !SceneOf(state).SetLineStartEnd(node, from, to))
    WarnIgnored(state, "this node is not a line");
  return 0;
}

void WarnUnlessLight(lua_State* state, bool is_light) {
  if (!is_light) WarnIgnored(state, "this node is not a light");
}

int SetLightDiffuse(lua_State* state) {
  const Vec3 color = CheckVector(state, 2);
  const NodeId node = NodeArgument(state, 1, false);
  if (node != NodeId::kNone) WarnUnlessLight(state, SceneOf(state).SetLightDiffuse(node, color));
  return 0;
}

int SetLightSpecular(lua_State* state) {
  const Vec3 color = CheckVector(state, 2);
  const NodeId node = NodeArgument(state, 1, false);
  if (node != NodeId::kNone) WarnUnlessLight(state, SceneOf(state).SetLightSpecular(node, color));
  return 0;
}

int SetLightRange(lua_State* state) {
  const float range = CheckFloat(state, 2);
  const NodeId node = NodeArgument(state, 1, false);
  if (node != NodeId::kNone) WarnUnlessLight(state, SceneOf(state).SetLightRange(node, range));
  return 0;
}

int ResetParticle(lua_State* state) {
  const NodeId node = NodeArgument(state, 1, true);
  if (node != NodeId::kNone && !SceneOf(state).ResetParticle(node))
    WarnIgnored(state, "this node is not a particle effect");
  return 0;
}

int SetParticleDirection(lua_State* state) {
  const Vec3 direction = CheckVector(state, 2);
  const NodeId node = PlainNode(state, 1);
  if (node != NodeId::kNone && !SceneOf(state).SetParticleDirection(node, direction))
    WarnIgnored(state, "this node is not a particle effect");
  return 0;
}

// IsVisisble and SetVisisble are the original sandbox's spellings; the correct spellings work too.
constexpr Binding kCoreSceneBindings[] = {
    {"CacheResource", CacheResource, 1, 1, WrongCount::kIgnored},
    {"GetPosition", GetPosition, 1, 1, WrongCount::kIgnored},
    {"GetRadius", GetRadius, 1, 1, WrongCount::kIgnored},
    {"GetRotation", GetRotation, 1, 1, WrongCount::kIgnored},
    {"IsVisible", IsVisible, 1, 1, WrongCount::kIgnored},
    {"IsVisisble", IsVisible, 1, 1, WrongCount::kIgnored},
    {"Remove", Remove, 1, 1, WrongCount::kIgnored},
    {"ResetParticle", ResetParticle, 1, 1, WrongCount::kIgnored},
    {"SetAxis", SetAxis, 4, 4, WrongCount::kIgnored},
    {"SetLightDiffuse", SetLightDiffuse, 2, 2, WrongCount::kIgnored},
    {"SetLightRange", SetLightRange, 2, 2, WrongCount::kIgnored},
    {"SetLightSpecular", SetLightSpecular, 2, 2, WrongCount::kIgnored},
    {"SetLineStartEnd", SetLineStartEnd, 3, 3, WrongCount::kIgnored},
    {"SetMaterial", SetMaterial, 2, 2, WrongCount::kIgnored},
    {"SetParticleDirection", SetParticleDirection, 2, 2, WrongCount::kIgnored},
    {"SetPosition", SetPosition, 2, 2, WrongCount::kIgnored},
    {"SetRotation", SetRotation, 2, 2, WrongCount::kIgnored},
    {"SetVisible", SetVisible, 2, 2, WrongCount::kIgnored},
    {"SetVisisble", SetVisible, 2, 2, WrongCount::kIgnored},
};

}  // namespace

void BindCoreScene(lua_State* state) {
  RegisterTable(state, "Core", kCoreSceneBindings);
}

}  // namespace soarbox::script
