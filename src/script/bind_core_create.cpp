// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <optional>

#include "script/api_call.h"
#include "script/script_asset.h"

// Core.Create...: a new scene node under the node of the first argument.

namespace soarbox::script {
namespace {

using world::NodeId;
using world::Scene;
using world::Vec3;
using enum WrongCount;

/// `kCreate`: the function of Scene.
template <auto kCreate, Made kMade, class... Values>
std::optional<Handle> MakeNode(lua_State* state, Scene& scene, NodeId parent, Values... values) {
  ChargeForCreation(state, kMade);
  if (scene.Depth(parent) >= Scene::kDeepest)
    luaL_error(state, "scene nodes are nested %d deep: no more can be attached below this one", Scene::kDeepest);
  const NodeId node = (scene.*kCreate)(parent, values...);
  WarnUnless(state, node != NodeId::kNone);
  if (node == NodeId::kNone) return std::nullopt;
  return Handle{ValueKind::kNode, Number(node)};
}

/// The numbers of tiles are used only together.
std::optional<Handle> CreateBox(lua_State* state, Scene& scene, NodeId parent, float width, float height, float length,
                                std::optional<float> u_tiles, std::optional<float> v_tiles) {
  return MakeNode<&Scene::CreateBox, Made::kNode>(state, scene, parent, width, height, length,
                                                  v_tiles ? u_tiles.value_or(1) : 1, v_tiles.value_or(1));
}

std::optional<Handle> CreateCapsule(lua_State* state, Scene& scene, NodeId parent, float height, float radius) {
  WarnOfShortCapsule(state, height, radius);
  return MakeNode<&Scene::CreateCapsule, Made::kNode>(state, scene, parent, height, radius);
}

std::optional<Handle> CreateMesh(lua_State* state, Scene& scene, NodeId parent) {
  return MakeNode<&Scene::CreateMesh, Made::kNode>(state, scene, parent, MeshArgument(state, 2));
}

std::optional<Handle> CreateDirectionalLight(lua_State* state, Scene& scene, NodeId parent, Vec3 direction) {
  if (direction == Vec3{}) WarnAtCaller(state, "the light has no direction: it shines straight down");
  return MakeNode<&Scene::CreateDirectionalLight, Made::kLight>(state, scene, parent, direction);
}

constexpr ApiFunction kCoreCreateFunctions[] = {
    {"Core.CreateBox", kCall<CreateBox>, kIgnored,
     "parent: Thing, width: number 0..1e6 [m], height: number 0..1e6 [m], length: number 0..1e6 [m], u_tiles: number = "
     "1, v_tiles: number = 1",
     "Node", "A box around the node's origin: width along x, height along y, length along z. It has no body.",
     R"(local box = Core.CreateBox(agent, 0.5, 1, 0.5)
Core.SetMaterial(box, "Red"))",
     false, kAnyCount},
    {"Core.CreateCapsule", kCall<CreateCapsule>, kIgnored,
     "parent: Thing, height: number 0..1e6 [m], radius: number 0..1e6 [m]", "Node",
     "An upright capsule around the node's origin; the height includes the caps.",
     R"(Core.CreateCapsule(agent, agent:GetHeight(), agent:GetRadius()))"},
    {"Core.CreateCircle", kCall<MakeNode<&Scene::CreateCircle, Made::kNode, float>>, kIgnored,
     "parent: Thing, radius: number 0..1e6 [m]", "Node", "A thin horizontal ring around the node's origin.",
     R"(local ring = Core.CreateCircle(agent, 1)
Core.SetPosition(ring, Vector.new(0, -0.7, 0)))"},
    {"Core.CreateCylinder", kCall<MakeNode<&Scene::CreateCylinder, Made::kNode, float, float>>, kIgnored,
     "parent: Thing, height: number 0..1e6 [m], radius: number 0..1e6 [m]", "Node",
     "An upright cylinder whose base is at the node's origin.", R"(Core.CreateCylinder(sandbox, 3, 0.2))"},
    {"Core.CreateDirectionalLight", kCall<CreateDirectionalLight>, kIgnored, "parent: Thing, direction: Vector", "Node",
     "A distant light that shines in this direction and casts shadows, like the sun.",
     R"(local sun = Core.CreateDirectionalLight(sandbox, Vector.new(1, -1, 1))
Core.SetLightDiffuse(sun, Vector.new(1.8, 1.4, 0.9)))"},
    {"Core.CreateLine", kCall<MakeNode<&Scene::CreateLine, Made::kNode, Vec3, Vec3>>, kIgnored,
     "parent: Thing, from: Vector [m], to: Vector [m]", "Node",
     "A thin line between two points in the parent's space. It is drawn until you remove it.",
     R"(local line = Core.CreateLine(sandbox, Vector.new(), Vector.new(0, 5, 0)))"},
    {"Core.CreateMesh", kCall<CreateMesh>, kIgnored, "parent: Thing, mesh: string", "Node",
     "A mesh of the media library, or a model from a .glb or .gltf file of the scenario's folder (docs/lua/models.md). "
     "An unknown name gives a box of 1 m and a warning; a file that cannot be read is an error that states the reason.",
     R"(Core.CreateMesh(agent, "models/nobiax_modular/modular_block.mesh"))"},
    {"Core.CreateParticle", kCall<MakeNode<&Scene::CreateParticle, Made::kNode, std::string_view>>, kIgnored,
     "parent: Thing, effect: string", "Node", "Starts a particle effect at the node's origin.",
     R"(local smoke = Core.CreateParticle(sandbox, "BulletImpact")
Core.SetPosition(smoke, Vector.new(0, 1, 0)))"},
    {"Core.CreatePlane", kCall<MakeNode<&Scene::CreatePlane, Made::kNode, float, float>>, kIgnored,
     "parent: Thing, length: number 0..1e6 [m], width: number 0..1e6 [m]", "Node",
     "A horizontal square that faces up, textured every 2 m. It has no body.", R"(Core.CreatePlane(sandbox, 10, 10))"},
    {"Core.CreatePointLight", kCall<MakeNode<&Scene::CreatePointLight, Made::kLight, Vec3>>, kIgnored,
     "parent: Thing, position: Vector [m]", "Node", "A lamp with a range of 30 m.",
     R"(local lamp = Core.CreatePointLight(sandbox, Vector.new(0, 3, 0))
Core.SetLightRange(lamp, 10))"},
};

}  // namespace

std::span<const ApiFunction> CoreCreateApi() {
  return kCoreCreateFunctions;
}

}  // namespace soarbox::script
