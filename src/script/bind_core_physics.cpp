// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/api_call.h"
#include "script/config_argument.h"

// Core: forces and masses of objects.

namespace soarbox::script {
namespace {

using world::Object;
using world::Vec3;
using enum WrongCount;

/// (object, point, axis [, other [, settings]])
void AddHinge(lua_State* state, Object& object, Vec3 point, Vec3 axis) {
  world::HingeDef hinge;
  hinge.point = point;
  hinge.axis = axis;
  const Object* other = lua_isnoneornil(state, 4) ? nullptr : &ObjectArgument(state, 4);
  ReadConfig(state, 5, {{"low", &hinge.low_deg}, {"high", &hinge.high_deg}, {"friction", &hinge.friction_nm}});
  CheckRoom(state, ContextOf(state).world.hinge_count(), ContextOf(state).budget.limits().objects, "hinges");
  WarnUnless(state, object.AddHinge(hinge, other));
}

constexpr ApiFunction kCorePhysicsFunctions[] = {
    {"Core.AddHinge", kCall<AddHinge>, kError,
     "object: Object, point: Vector -1e6..1e6 [m], axis: Vector, other: Object = none, settings: table = none", "",
     "Attaches an object to an axis through the point, so that it can only turn about this axis, like a door. The axis "
     "is fixed in the world, or moves with the other object. Settings: low and high, the limits of the angle in "
     "degrees from the present orientation, and friction, the maximum braking torque in N m. The hinge is removed "
     "together with either object.",
     R"(Core.AddHinge(object, Vector.new(4, 1, 5), Vector.new(0, 1, 0), nil, {low = -90, high = 90, friction = 2}))",
     true},
    {"Core.ApplyAngularImpulse", kCall<&Object::ApplyAngularImpulse>, kIgnored,
     "object: Object, impulse: Vector -1e12..1e12 [N m s]", "", "Changes the object's angular velocity at once.",
     R"(Core.ApplyAngularImpulse(object, Vector.new(0, 10, 0)))"},
    {"Core.ApplyForce", kCall<&Object::ApplyForce>, kIgnored, "object: Object, force: Vector -1e12..1e12 [N]", "",
     "Pushes at the centre of mass during the next step. The forces of one step add up.",
     R"(Core.ApplyForce(object, Vector.new(0, 0, 100)))"},
    {"Core.ApplyImpulse", kCall<&Object::ApplyImpulse>, kIgnored, "object: Object, force: Vector -1e12..1e12 [N]", "",
     "Applies a force for one step, like ApplyForce: the speed changes by force / mass / 30.",
     R"(-- 15000 N on a block of 15 kg give it 33 m/s.
Core.SetMass(object, 15)
Core.ApplyImpulse(object, Vector.new(0, 0, 15000)))"},
    {"Core.GetMass", kCall<&Object::Mass>, kIgnored, "object: Object", "number [kg]",
     "The mass of an object; 0 if it is fixed.", R"(print(Core.GetMass(object))  --> 1)"},
    {"Core.RemoveHinges", kCall<&Object::RemoveHinges>, kError, "object: Object", "",
     "Removes the hinges that were added for this object, so that it moves freely again.",
     R"(Core.RemoveHinges(object))", true},
    {"Core.SetGravity", kCall<&Object::SetGravity>, kIgnored,
     "object: Object, acceleration: Vector -100000..100000 [m/s^2]", "", "Gives an object its own gravity.",
     R"(Core.SetGravity(object, Vector.new(0, -1.6, 0)))"},
    {"Core.SetMass", kCall<&Object::SetMass>, kIgnored, "object: Object, mass: number 0..1e9 [kg]", "",
     "Changes an object's mass. 0 fixes it: only SetPosition moves it, and agents can walk on it.",
     R"(Core.SetMass(object, 0)
print(Core.GetMass(object))  --> 0)"},
};

}  // namespace

std::span<const ApiFunction> CorePhysicsApi() {
  return kCorePhysicsFunctions;
}

}  // namespace soarbox::script
