// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>
#include <lua.hpp>

#include "script/api_call.h"
#include "world/rotation.h"

// Core: positions and appearance of scene nodes and objects.

namespace soarbox::script {
namespace {

using world::NodeId;
using world::Scene;
using world::Vec3;
using enum WrongCount;

/// The kind of a handle in argument 1; kVector for other values.
ValueKind KindOfFirst(lua_State* state) {
  const Handle* handle = ToHandle(state, 1);
  return handle ? handle->kind : ValueKind::kVector;
}

/// Returns the node in argument 1; kNone after a warning, also for the sandbox and agents.
NodeId PlainNode(lua_State* state) {
  if (KindOfFirst(state) == ValueKind::kNode) return NodeArgument(state, 1);
  WarnIgnored(state, lua_pushfstring(state, "argument 1 is not a scene node but %s", NameOfValue(state, 1)));
  return NodeId::kNone;
}

void CacheResource(lua_State* state, std::string_view name) {
  ContextOf(state).world.catalog().CheckResource(name);
}

std::optional<Vec3> GetPosition(lua_State* state, Scene& scene) {
  if (KindOfFirst(state) == ValueKind::kObject) return ObjectArgument(state, 1).Position();
  if (KindOfFirst(state) == ValueKind::kAgent) return AgentArgument(state, 1).Position();
  const NodeId node = PlainNode(state);
  return node != NodeId::kNone ? std::optional(scene.Position(node)) : std::nullopt;
}

std::optional<float> GetRadius(lua_State* state, Scene& scene) {
  if (KindOfFirst(state) == ValueKind::kObject) return ObjectArgument(state, 1).Radius();
  const NodeId node = KindOfFirst(state) == ValueKind::kAgent ? AgentArgument(state, 1).node() : PlainNode(state);
  return node != NodeId::kNone ? std::optional(scene.Radius(node)) : std::nullopt;
}

Vec3 GetRotation(const world::Object& object) {
  return world::ToPitchYawRoll(object.Orientation());
}

/// (object or node, position)
int SetPosition(lua_State* state) {
  const Vec3 position = CheckVector(state, 2);
  WarnUnless(state, KindOfFirst(state) == ValueKind::kObject
                        ? ObjectArgument(state, 1).SetPosition(position)
                        : ContextOf(state).world.scene().SetPosition(NodeArgument(state, 1), position));
  return 0;
}

/// Turns the object or node in argument 1.
int Orient(lua_State* state, world::Quat orientation) {
  WarnUnless(state, KindOfFirst(state) == ValueKind::kObject
                        ? ObjectArgument(state, 1).SetOrientation(orientation)
                        : ContextOf(state).world.scene().SetOrientation(NodeArgument(state, 1), orientation));
  return 0;
}

int SetRotation(lua_State* state) {
  return Orient(state, world::FromRotationVector(CheckVector(state, 2)));
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
  return Orient(state, world::FromAxes(x, y, z));
}

void SetMaterial(lua_State* state, Scene& scene, NodeId node, std::string_view material) {
  if (!scene.SetMaterial(node, material))
    WarnIgnored(state, "nothing that can have a material is attached to this node");
}

int Remove(lua_State* state) {
  if (KindOfFirst(state) == ValueKind::kObject)
    return luaL_error(state, "Core.Remove is for scene nodes; use Sandbox.RemoveObject");
  ContextOf(state).world.scene().Remove(NodeArgument(state, 1));
  return 0;
}

// These functions of Scene return whether the node is one of the right kind.

void SetLineStartEnd(lua_State* state, Scene& scene, NodeId line, Vec3 from, Vec3 to) {
  if (!scene.SetLineStartEnd(line, from, to)) WarnIgnored(state, "this node is not a line");
}

template <auto kSet, class Value>
void SetLight(lua_State* state, Scene& scene, NodeId light, Value value) {
  if (!(scene.*kSet)(light, value)) WarnIgnored(state, "this node is not a light");
}

template <auto kChange, class... Values>
void ChangeParticle(lua_State* state, Scene& scene, NodeId effect, Values... values) {
  if (!(scene.*kChange)(effect, values...)) WarnIgnored(state, "this node is not a particle effect");
}

// IsVisisble and SetVisisble are the original sandbox's spellings; the correct spellings work too.
constexpr ApiFunction kCoreSceneFunctions[] = {
    {"Core.CacheResource", kCall<CacheResource>, kIgnored, "name: string", "",
     "Checks that a mesh, material, sky or particle effect of this name exists.",
     R"(Core.CacheResource("models/nobiax_modular/modular_block.mesh"))"},
    {"Core.GetPosition", kCall<GetPosition>, kIgnored, "thing: value", "Vector [m]",
     "The position of an object's or agent's centre in the world, or of a node in its parent's space.",
     R"(print(Core.GetPosition(object).x)  --> 5)"},
    {"Core.GetRadius", kCall<GetRadius>, kIgnored, "thing: value", "number [m]",
     "Half the diagonal of the bounding box of an object, agent or node.",
     R"(print(Core.GetRadius(object) > 0.8)  --> true)"},
    {"Core.GetRotation", kCall<GetRotation>, kIgnored, "object: Object", "Vector [deg]",
     "Pitch, yaw and roll of an object, each computed from one of its axes. In general, they differ from the argument "
     "of SetRotation.",
     R"(Core.SetRotation(object, Vector.new(0, 30, 0))
print(string.format("%.0f", Core.GetRotation(object).y))  --> 30)"},
    {"Core.IsVisible", kCall<&Scene::IsVisible>, kIgnored, "node: Scene", "boolean", "Whether a node is visible.",
     R"(print(Core.IsVisible(node))  --> true)", true},
    {"Core.IsVisisble", kCall<&Scene::IsVisible>, kIgnored, "node: Scene", "boolean",
     "The same as IsVisible, with the spelling of the first sandbox.", R"(print(Core.IsVisisble(node))  --> true)"},
    {"Core.Remove", Remove, kIgnored, "node: Node", "",
     "Removes a node from the scene, with everything attached to it. For objects, use Sandbox.RemoveObject.",
     R"(Core.Remove(node))"},
    {"Core.ResetParticle", kCall<ChangeParticle<&Scene::ResetParticle>>, kIgnored, "effect: Thing", "",
     "Plays a particle effect from its start.", R"(Core.ResetParticle(effect))"},
    {"Core.SetAxis", SetAxis, kIgnored, "thing: Placed, x: Vector, y: Vector, z: Vector", "",
     "Turns an object or a node so that these vectors are its axes. They must be perpendicular, right-handed and of "
     "length 1.",
     R"(Core.SetAxis(object, Vector.new(0, 0, -1), Vector.new(0, 1, 0), Vector.new(1, 0, 0)))"},
    {"Core.SetLightDiffuse", kCall<SetLight<&Scene::SetLightDiffuse, Vec3>>, kIgnored, "light: Scene, color: Vector",
     "", "Sets the colour of a light; values above 1 are brighter.",
     R"(Core.SetLightDiffuse(light, Vector.new(1, 0.8, 0.6)))"},
    {"Core.SetLightRange", kCall<SetLight<&Scene::SetLightRange, float>>, kIgnored,
     "light: Scene, range: number 0.001..1e6 [m]", "", "Sets the range of a lamp.", R"(Core.SetLightRange(light, 12))"},
    {"Core.SetLightSpecular", kCall<SetLight<&Scene::SetLightSpecular, Vec3>>, kIgnored, "light: Scene, color: Vector",
     "", "Sets the colour of a light's highlights.", R"(Core.SetLightSpecular(light, Vector.new(1)))"},
    {"Core.SetLineStartEnd", kCall<SetLineStartEnd>, kIgnored, "line: Thing, from: Vector [m], to: Vector [m]", "",
     "Moves the ends of a line that CreateLine created.",
     R"(local line = Core.CreateLine(sandbox, Vector.new(), Vector.new(1))
Core.SetLineStartEnd(line, Vector.new(), agent:GetPosition()))"},
    {"Core.SetMaterial", kCall<SetMaterial>, kIgnored, "node: Scene, material: string", "",
     "Gives everything attached to a node this material (docs/lua/names.md). An unknown name gives White and a "
     "warning. A figure such as Soarbox/Sheep draws a box as a sheep of the same size; its body remains a box.",
     R"(Core.SetMaterial(node, "Ground2"))"},
    {"Core.SetParticleDirection", kCall<ChangeParticle<&Scene::SetParticleDirection, Vec3>>, kIgnored,
     "effect: Node, direction: Vector", "", "Sets the direction of a particle effect.",
     R"(Core.SetParticleDirection(effect, Vector.new(0, 1, 0)))"},
    {"Core.SetPosition", SetPosition, kIgnored, "thing: Placed, position: Vector -1e6..1e6 [m]", "",
     "Moves an object to a place in the world at once, or a node to a place in its parent's space.",
     R"(Core.SetPosition(object, Vector.new(0, 4, 0))
print(Core.GetPosition(object).y)  --> 4)"},
    {"Core.SetRotation", SetRotation, kIgnored, "thing: Placed, rotation: Vector [deg]", "",
     "Turns an object or a node: about z first, then y, then x.", R"(Core.SetRotation(node, Vector.new(0, 45, 0)))"},
    {"Core.SetVisible", kCall<&Scene::SetVisible>, kIgnored, "node: Scene, visible: boolean", "",
     "Shows or hides a node and everything below it.",
     R"(Core.SetVisible(node, false)
print(Core.IsVisible(node))  --> false)",
     true},
    {"Core.SetVisisble", kCall<&Scene::SetVisible>, kIgnored, "node: Scene, visible: boolean", "",
     "The same as SetVisible, with the spelling of the first sandbox.", R"(Core.SetVisisble(node, true))"},
};

}  // namespace

std::span<const ApiFunction> CoreSceneApi() {
  return kCoreSceneFunctions;
}

}  // namespace soarbox::script
