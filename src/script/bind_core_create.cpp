// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/script_asset.h"

// Core.Create...: a new scene node under the node of the first argument. Returns nothing if that has no node.

namespace soarbox::script {
namespace {

/// Runs create(scene, parent) and pushes the new node.
template <class Create>
int MakeNode(lua_State* state, Create create, Made made = Made::kNode) {
  const world::NodeId parent = NodeArgument(state, 1, true);
  if (parent == world::NodeId::kNone) return 0;
  ChargeForCreation(state, made);
  if (ContextOf(state).world.scene().Depth(parent) >= world::Scene::kDeepest)
    return luaL_error(state, "scene nodes are nested %d deep: no more can be attached below this one",
                      world::Scene::kDeepest);
  const world::NodeId node = create(ContextOf(state).world.scene(), parent);
  if (node == world::NodeId::kNone) {
    WarnUnless(state, false);
    return 0;
  }
  PushNode(state, node);
  return 1;
}

int CreateBox(lua_State* state) {
  const float width = CheckFloat(state, 2), height = CheckFloat(state, 3), length = CheckFloat(state, 4);
  const bool tiled = lua_gettop(state) >= 6;
  const float u_tile = tiled ? CheckFloat(state, 5) : 1, v_tile = tiled ? CheckFloat(state, 6) : 1;
  return MakeNode(state, [&](world::Scene& scene, world::NodeId parent) {
    return scene.CreateBox(parent, width, height, length, u_tile, v_tile);
  });
}

int CreateCapsule(lua_State* state) {
  const float height = CheckFloat(state, 2), radius = CheckFloat(state, 3);
  WarnOfShortCapsule(state, height, radius);
  return MakeNode(
      state, [&](world::Scene& scene, world::NodeId parent) { return scene.CreateCapsule(parent, height, radius); });
}

int CreateCircle(lua_State* state) {
  const float radius = CheckFloat(state, 2);
  return MakeNode(state, [&](world::Scene& scene, world::NodeId parent) { return scene.CreateCircle(parent, radius); });
}

int CreateCylinder(lua_State* state) {
  const float height = CheckFloat(state, 2), radius = CheckFloat(state, 3);
  return MakeNode(
      state, [&](world::Scene& scene, world::NodeId parent) { return scene.CreateCylinder(parent, height, radius); });
}

int CreateLine(lua_State* state) {
  const world::Vec3 from = CheckVector(state, 2), to = CheckVector(state, 3);
  return MakeNode(state, [&](world::Scene& scene, world::NodeId parent) { return scene.CreateLine(parent, from, to); });
}

int CreateMesh(lua_State* state) {
  const std::string_view mesh = MeshArgument(state, 2);
  return MakeNode(state, [&](world::Scene& scene, world::NodeId parent) { return scene.CreateMesh(parent, mesh); });
}

int CreatePlane(lua_State* state) {
  const float length = CheckFloat(state, 2), width = CheckFloat(state, 3);
  return MakeNode(state,
                  [&](world::Scene& scene, world::NodeId parent) { return scene.CreatePlane(parent, length, width); });
}

int CreateParticle(lua_State* state) {
  const std::string_view name = TextArgument(state, 2);
  return MakeNode(state, [&](world::Scene& scene, world::NodeId parent) { return scene.CreateParticle(parent, name); });
}

int CreateDirectionalLight(lua_State* state) {
  const world::Vec3 direction = CheckVector(state, 2);
  if (direction == world::Vec3{}) WarnAtCaller(state, "the light has no direction: it shines straight down");
  return MakeNode(
      state, [&](world::Scene& scene, world::NodeId parent) { return scene.CreateDirectionalLight(parent, direction); },
      Made::kLight);
}

int CreatePointLight(lua_State* state) {
  const world::Vec3 position = CheckVector(state, 2);
  return MakeNode(
      state, [&](world::Scene& scene, world::NodeId parent) { return scene.CreatePointLight(parent, position); },
      Made::kLight);
}

constexpr Binding kCoreCreateBindings[] = {
    {"CreateBox", CreateBox, 4, kAnyCount, WrongCount::kIgnored},
    {"CreateCapsule", CreateCapsule, 3, 3, WrongCount::kIgnored},
    {"CreateCircle", CreateCircle, 2, 2, WrongCount::kIgnored},
    {"CreateCylinder", CreateCylinder, 3, 3, WrongCount::kIgnored},
    {"CreateDirectionalLight", CreateDirectionalLight, 2, 2, WrongCount::kIgnored},
    {"CreateLine", CreateLine, 3, 3, WrongCount::kIgnored},
    {"CreateMesh", CreateMesh, 2, 2, WrongCount::kIgnored},
    {"CreateParticle", CreateParticle, 2, 2, WrongCount::kIgnored},
    {"CreatePlane", CreatePlane, 3, 3, WrongCount::kIgnored},
    {"CreatePointLight", CreatePointLight, 2, 2, WrongCount::kIgnored},
};

}  // namespace

void BindCoreCreate(lua_State* state) {
  RegisterTable(state, "Core", kCoreCreateBindings);
}

}  // namespace soarbox::script
