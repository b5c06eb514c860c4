// SPDX-License-Identifier: BSD-2-Clause
#include "script/bind_arguments.h"

#include <lua.hpp>
#include <string>

#include "script/argument_check.h"
#include "script/binding.h"
#include "script/lua_order.h"
#include "world/rotation.h"

namespace soarbox::script {
namespace {

constexpr std::uint64_t kCreationPrice = 5'000;
constexpr std::uint64_t kAgentPrice = 15'000;
constexpr std::uint64_t kCrowdedPrice = 100'000;
constexpr std::size_t kLongestText = 65'536;
constexpr std::size_t kMostPoints = 10'000;

void RaiseGone(lua_State* state, int index, const char* what) {
  ArgumentError(state, index, lua_pushfstring(state, "this %s was removed", what));
}

}  // namespace

world::Agent& AgentArgument(lua_State* state, int index) {
  const world::EntityId id{CheckHandle(state, index, ValueKind::kAgent)};
  world::Agent* agent = ContextOf(state).world.FindAgent(id);
  if (!agent || agent->IsGone()) RaiseGone(state, index, "agent");
  return *agent;
}

world::Object& ObjectArgument(lua_State* state, int index) {
  const world::EntityId id{CheckHandle(state, index, ValueKind::kObject)};
  world::Object* object = ContextOf(state).world.FindObject(id);
  if (!object) RaiseGone(state, index, "sandbox object");
  return *object;
}

world::NodeId NodeArgument(lua_State* state, int index) {
  const Handle* handle = ToHandle(state, index);
  if (!handle) CheckHandle(state, index, ValueKind::kNode);
  const world::World& world = ContextOf(state).world;
  if (handle->kind == ValueKind::kNode) {
    const world::NodeId node{handle->number};
    if (!world.scene().Contains(node)) RaiseGone(state, index, "scene node");
    return node;
  }
  const world::NodeId node = world.NodeOf(world::EntityId{handle->number});
  if (node == world::NodeId::kNone)
    RaiseGone(state, index, handle->kind == ValueKind::kAgent ? "agent" : "sandbox object");
  return node;
}

world::UiId UiArgument(lua_State* state, int index) {
  const world::UiId id{CheckHandle(state, index, ValueKind::kUi)};
  if (!ContextOf(state).world.ui().Find(id)) RaiseGone(state, index, "UI component");
  return id;
}

Body BodyArgument(lua_State* state, int index) {
  const Handle* handle = ToHandle(state, index);
  if (handle && handle->kind == ValueKind::kAgent)
    ArgumentError(state, index, "a mesh expected, got an agent; pass the mesh that is attached to it");
  const world::NodeId node = NodeArgument(state, index);
  world::Animator* animator = ContextOf(state).world.scene().AnimatorOf(node);
  if (!animator) ArgumentError(state, index, "this has no mesh with a skeleton, so it has no animations");
  return {node, *animator};
}

world::Scene::FoundAnimation AnimationArgument(lua_State* state, int index) {
  const world::AnimationId id{CheckHandle(state, index, ValueKind::kAnimation)};
  const auto found = ContextOf(state).world.scene().FindAnimation(id);
  if (!found.animator) ArgumentError(state, index, "the mesh of this animation was removed");
  return found;
}

std::string_view TextArgument(lua_State* state, int index) {
  if (lua_isstring(state, index) == 0)
    ArgumentError(state, index, lua_pushfstring(state, "string expected, got %s", NameOfValue(state, index)));
  std::size_t length = 0;
  const char* text = lua_tolstring(state, index, &length);
  if (length > kLongestText) ArgumentError(state, index, "a text that the world keeps has 65536 bytes at most");
  return {text, length};
}

std::vector<world::Vec3> VectorsArgument(lua_State* state, int index) {
  luaL_checktype(state, index, LUA_TTABLE);
  int count = 0;
  const bool plain = IsPlainArray(state, index, count);
  if (!plain) {
    PushOrderedKeys(state, index);
    count = static_cast<int>(lua_objlen(state, -1));
  }
  luaL_argcheck(state, static_cast<std::size_t>(count) <= kMostPoints, index, "a path has 10000 points at most");
  LuaMachine::Of(state).Charge(static_cast<std::uint64_t>(count));
  std::vector<world::Vec3> vectors;
  for (int i = 1; i <= count; ++i) {
    if (plain) {
      lua_rawgeti(state, index, i);
    } else {
      lua_rawgeti(state, -1, i);
      lua_rawget(state, index);
    }
    if (const world::Vec3* vector = ToVector(state, -1); vector && world::IsFinite(*vector)) {
      vectors.push_back(*vector);
    } else {
      const char* what = vector ? "a Vector that is not finite" : NameOfValue(state, -1);
      WarnAtCallerOnce(state, "point " + std::to_string(i) + " is " + what + ": it is left out", "points");
    }
    lua_pop(state, 1);
  }
  if (!plain) lua_pop(state, 1);
  return vectors;
}

void WarnUnless(lua_State* state, bool accepted) {
  if (!accepted) WarnIgnored(state, "a value is not a finite number or does not fit here");
}

void WarnOfShortCapsule(lua_State* state, float height, float radius) {
  if (height >= 2 * radius) return;
  WarnAtCallerOnce(state, "the height is less than the two radii of the caps: their sum is used", "capsule");
}

void ChargeForCreation(lua_State* state, Made made) {
  world::World& world = ContextOf(state).world;
  // In a pile of bodies, each further body is compared with all others.
  const std::uint64_t price = made == Made::kAgent ? kAgentPrice : kCreationPrice;
  LuaMachine::Of(state).Charge(world.IsCrowded() ? price + kCrowdedPrice : price);
  const WorldLimits& limits = ContextOf(state).budget.limits();
  if (made == Made::kObject) CheckRoom(state, world.ObjectIds().size(), limits.objects, "objects");
  if (made == Made::kLight) CheckRoom(state, world.scene().light_count(), limits.lights, "lights");
  if (made == Made::kPanel) CheckRoom(state, world.ui().size(), limits.panels, "panels");
  if (made != Made::kPanel) CheckRoom(state, world.scene().node_count(), limits.nodes, "scene nodes");
}

void CheckRoom(lua_State* state, std::size_t count, std::size_t most, const char* things) {
  if (count < most) return;
  luaL_error(state, "this world already has %d %s: no more can be made", static_cast<int>(count), things);
}

void PushPoint(lua_State* state, float x, float y) {
  lua_createtable(state, 0, 2);
  lua_pushnumber(state, x);
  lua_setfield(state, -2, "x");
  lua_pushnumber(state, y);
  lua_setfield(state, -2, "y");
}

}  // namespace soarbox::script
