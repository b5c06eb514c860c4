// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

namespace soarbox::script {
namespace {

constexpr ApiFunction kCoreFunctions[] = {
    {"Core.AddHinge",
     "object: Object, point: Vector -1e6..1e6 [m], axis: Vector, other: value = none, settings: table = none", "",
     "Attaches an object to an axis through the point, so that it can only turn about this axis, like a door. The axis "
     "is fixed in the world, or moves with the other object. Settings: low and high, the limits of the angle in "
     "degrees from the present orientation, and friction, the maximum braking torque in N m. The hinge is removed "
     "together with either object.",
     R"(Core.AddHinge(object, Vector.new(4, 1, 5), Vector.new(0, 1, 0), nil, {low = -90, high = 90, friction = 2}))",
     true},
    {"Core.ApplyAngularImpulse", "object: Object, impulse: Vector -1e12..1e12 [N m s]", "",
     "Changes the object's angular velocity at once.", R"(Core.ApplyAngularImpulse(object, Vector.new(0, 10, 0)))"},
    {"Core.ApplyForce", "object: Object, force: Vector -1e12..1e12 [N]", "",
     "Pushes at the centre of mass during the next step. The forces of one step add up.",
     R"(Core.ApplyForce(object, Vector.new(0, 0, 100)))"},
    {"Core.ApplyImpulse", "object: Object, force: Vector -1e12..1e12 [N]", "",
     "Applies a force for one step, like ApplyForce: the speed changes by force / mass / 30.",
     R"(-- 15000 N on a block of 15 kg give it 33 m/s.
Core.SetMass(object, 15)
Core.ApplyImpulse(object, Vector.new(0, 0, 15000)))"},
    {"Core.CacheResource", "name: string", "",
     "Checks that a mesh, material, sky or particle effect of this name exists.",
     R"(Core.CacheResource("models/nobiax_modular/modular_block.mesh"))"},
    {"Core.CreateBox",
     "parent: Thing, width: number 0..1e6 [m], height: number 0..1e6 [m], length: number 0..1e6 [m], u_tiles: number = "
     "1, v_tiles: number = 1",
     "Node", "A box around the node's origin: width along x, height along y, length along z. It has no body.",
     R"(local box = Core.CreateBox(agent, 0.5, 1, 0.5)
Core.SetMaterial(box, "Red"))"},
    {"Core.CreateCapsule", "parent: Thing, height: number 0..1e6 [m], radius: number 0..1e6 [m]", "Node",
     "An upright capsule around the node's origin; the height includes the caps.",
     R"(Core.CreateCapsule(agent, agent:GetHeight(), agent:GetRadius()))"},
    {"Core.CreateCircle", "parent: Thing, radius: number 0..1e6 [m]", "Node",
     "A thin horizontal ring around the node's origin.",
     R"(local ring = Core.CreateCircle(agent, 1)
Core.SetPosition(ring, Vector.new(0, -0.7, 0)))"},
    {"Core.CreateCylinder", "parent: Thing, height: number 0..1e6 [m], radius: number 0..1e6 [m]", "Node",
     "An upright cylinder whose base is at the node's origin.", R"(Core.CreateCylinder(sandbox, 3, 0.2))"},
    {"Core.CreateDirectionalLight", "parent: Thing, direction: Vector", "Node",
     "A distant light that shines in this direction and casts shadows, like the sun.",
     R"(local sun = Core.CreateDirectionalLight(sandbox, Vector.new(1, -1, 1))
Core.SetLightDiffuse(sun, Vector.new(1.8, 1.4, 0.9)))"},
    {"Core.CreateLine", "parent: Thing, from: Vector [m], to: Vector [m]", "Node",
     "A thin line between two points in the parent's space. It is drawn until you remove it.",
     R"(local line = Core.CreateLine(sandbox, Vector.new(), Vector.new(0, 5, 0)))"},
    {"Core.CreateMesh", "parent: Thing, mesh: string", "Node",
     "A mesh of the media library, or a model from a .glb or .gltf file of the scenario's folder (docs/lua/models.md). "
     "An unknown name gives a box of 1 m and a warning; a file that cannot be read is an error that states the reason.",
     R"(Core.CreateMesh(agent, "models/nobiax_modular/modular_block.mesh"))"},
    {"Core.CreateParticle", "parent: Thing, effect: string", "Node", "Starts a particle effect at the node's origin.",
     R"(local smoke = Core.CreateParticle(sandbox, "BulletImpact")
Core.SetPosition(smoke, Vector.new(0, 1, 0)))"},
    {"Core.CreatePlane", "parent: Thing, length: number 0..1e6 [m], width: number 0..1e6 [m]", "Node",
     "A horizontal square that faces up, textured every 2 m. It has no body.", R"(Core.CreatePlane(sandbox, 10, 10))"},
    {"Core.CreatePointLight", "parent: Thing, position: Vector [m]", "Node", "A lamp with a range of 30 m.",
     R"(local lamp = Core.CreatePointLight(sandbox, Vector.new(0, 3, 0))
Core.SetLightRange(lamp, 10))"},
    {"Core.DrawCircle", "center: Vector [m], radius: number 0..1e30 [m], color: Vector", "",
     "Draws a horizontal circle for one step.", R"(Core.DrawCircle(agent:GetTarget(), 1, Vector.new(1, 0, 0)))"},
    {"Core.DrawLine", "from: Vector [m], to: Vector [m], color: Vector", "", "Draws a line for one step.",
     R"(Core.DrawLine(agent:GetPosition(), agent:GetTarget(), Vector.new(0, 1, 0)))"},
    {"Core.DrawSphere", "center: Vector [m], radius: number 0..1e30 [m], color: Vector, filled: boolean = false", "",
     "Draws a wire sphere for one step; if filled, it is translucent inside.",
     R"(Core.DrawSphere(agent:GetPosition(), 1, Vector.new(0, 0, 1), true))"},
    {"Core.DrawSquare", "center: Vector [m], side: number 0..1e6 [m], color: Vector, filled: boolean = false", "",
     "Draws a horizontal square for one step.", R"(Core.DrawSquare(Vector.new(), 100, Vector.new(1, 0, 0)))"},
    {"Core.GetMass", "object: Object", "number [kg]", "The mass of an object; 0 if it is fixed.",
     R"(print(Core.GetMass(object))  --> 1)"},
    {"Core.GetPosition", "thing: value", "Vector [m]",
     "The position of an object's or agent's centre in the world, or of a node in its parent's space.",
     R"(print(Core.GetPosition(object).x)  --> 5)"},
    {"Core.GetRadius", "thing: value", "number [m]",
     "Half the diagonal of the bounding box of an object, agent or node.",
     R"(print(Core.GetRadius(object) > 0.8)  --> true)"},
    {"Core.GetRotation", "object: Object", "Vector [deg]",
     "Pitch, yaw and roll of an object, each computed from one of its axes. In general, they differ from the argument "
     "of SetRotation.",
     R"(Core.SetRotation(object, Vector.new(0, 30, 0))
print(string.format("%.0f", Core.GetRotation(object).y))  --> 30)"},
    {"Core.IsVisible", "node: Scene", "boolean", "Whether a node is visible.",
     R"(print(Core.IsVisible(node))  --> true)", true},
    {"Core.IsVisisble", "node: Scene", "boolean", "The same as IsVisible, with the spelling of the first sandbox.",
     R"(print(Core.IsVisisble(node))  --> true)"},
    {"Core.Remove", "node: Node", "",
     "Removes a node from the scene, with everything attached to it. For objects, use Sandbox.RemoveObject.",
     R"(Core.Remove(node))"},
    {"Core.RemoveHinges", "object: Object", "",
     "Removes the hinges that were added for this object, so that it moves freely again.",
     R"(Core.RemoveHinges(object))", true},
    {"Core.ResetParticle", "effect: Thing", "", "Plays a particle effect from its start.",
     R"(Core.ResetParticle(effect))"},
    {"Core.SetAxis", "thing: Placed, x: Vector, y: Vector, z: Vector", "",
     "Turns an object or a node so that these vectors are its axes. They must be perpendicular, right-handed and of "
     "length 1.",
     R"(Core.SetAxis(object, Vector.new(0, 0, -1), Vector.new(0, 1, 0), Vector.new(1, 0, 0)))"},
    {"Core.SetGravity", "object: Object, acceleration: Vector -100000..100000 [m/s^2]", "",
     "Gives an object its own gravity.", R"(Core.SetGravity(object, Vector.new(0, -1.6, 0)))"},
    {"Core.SetLightDiffuse", "light: Scene, color: Vector", "",
     "Sets the colour of a light; values above 1 are brighter.",
     R"(Core.SetLightDiffuse(light, Vector.new(1, 0.8, 0.6)))"},
    {"Core.SetLightRange", "light: Scene, range: number 0.001..1e6 [m]", "", "Sets the range of a lamp.",
     R"(Core.SetLightRange(light, 12))"},
    {"Core.SetLightSpecular", "light: Scene, color: Vector", "", "Sets the colour of a light's highlights.",
     R"(Core.SetLightSpecular(light, Vector.new(1)))"},
    {"Core.SetLineStartEnd", "line: Thing, from: Vector [m], to: Vector [m]", "",
     "Moves the ends of a line that CreateLine created.",
     R"(local line = Core.CreateLine(sandbox, Vector.new(), Vector.new(1))
Core.SetLineStartEnd(line, Vector.new(), agent:GetPosition()))"},
    {"Core.SetMass", "object: Object, mass: number 0..1e9 [kg]", "",
     "Changes an object's mass. 0 fixes it: only SetPosition moves it, and agents can walk on it.",
     R"(Core.SetMass(object, 0)
print(Core.GetMass(object))  --> 0)"},
    {"Core.SetMaterial", "node: Scene, material: string", "",
     "Gives everything attached to a node this material (docs/lua/names.md). An unknown name gives White and a "
     "warning. A figure such as Soarbox/Sheep draws a box as a sheep of the same size; its body remains a box.",
     R"(Core.SetMaterial(node, "Ground2"))"},
    {"Core.SetParticleDirection", "effect: Node, direction: Vector", "", "Sets the direction of a particle effect.",
     R"(Core.SetParticleDirection(effect, Vector.new(0, 1, 0)))"},
    {"Core.SetPosition", "thing: Placed, position: Vector -1e6..1e6 [m]", "",
     "Moves an object to a place in the world at once, or a node to a place in its parent's space.",
     R"(Core.SetPosition(object, Vector.new(0, 4, 0))
print(Core.GetPosition(object).y)  --> 4)"},
    {"Core.SetRotation", "thing: Placed, rotation: Vector [deg]", "",
     "Turns an object or a node: about z first, then y, then x.", R"(Core.SetRotation(node, Vector.new(0, 45, 0)))"},
    {"Core.SetVisible", "node: Scene, visible: boolean", "", "Shows or hides a node and everything below it.",
     R"(Core.SetVisible(node, false)
print(Core.IsVisible(node))  --> false)",
     true},
    {"Core.SetVisisble", "node: Scene, visible: boolean", "",
     "The same as SetVisible, with the spelling of the first sandbox.", R"(Core.SetVisisble(node, true))"},
};

}  // namespace

std::span<const ApiFunction> CoreApi() {
  return kCoreFunctions;
}

}  // namespace soarbox::script
