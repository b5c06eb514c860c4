// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/config_argument.h"

// Core: forces and masses of objects.

namespace soarbox::script {
namespace {

using world::Vec3;

int ApplyForce(lua_State* state) {
  const Vec3 force = CheckVector(state, 2);
  if (world::Object* object = ObjectArgument(state, 1)) WarnUnless(state, object->ApplyForce(force));
  return 0;
}

int ApplyImpulse(lua_State* state) {
  const Vec3 force = CheckVector(state, 2);
  if (world::Object* object = ObjectArgument(state, 1)) WarnUnless(state, object->ApplyImpulse(force));
  return 0;
}

int ApplyAngularImpulse(lua_State* state) {
  const Vec3 impulse = CheckVector(state, 2);
  if (world::Object* object = ObjectArgument(state, 1)) WarnUnless(state, object->ApplyAngularImpulse(impulse));
  return 0;
}

int GetMass(lua_State* state) {
  const world::Object* object = ObjectArgument(state, 1);
  if (!object) return 0;
  lua_pushnumber(state, object->Mass());
  return 1;
}

int SetMass(lua_State* state) {
  const float mass = CheckFloat(state, 2);
  if (world::Object* object = ObjectArgument(state, 1)) WarnUnless(state, object->SetMass(mass));
  return 0;
}

int SetGravity(lua_State* state) {
  const Vec3 gravity = CheckVector(state, 2);
  if (world::Object* object = ObjectArgument(state, 1)) WarnUnless(state, object->SetGravity(gravity));
  return 0;
}

/// (object, point, axis [, other [, settings]])
int AddHinge(lua_State* state) {
  world::HingeDef hinge;
  hinge.point = CheckVector(state, 2);
  hinge.axis = CheckVector(state, 3);
  world::Object* object = ObjectArgument(state, 1);
  const world::Object* other = lua_isnoneornil(state, 4) ? nullptr : ObjectArgument(state, 4);
  if (!object || (!other && !lua_isnoneornil(state, 4))) return 0;
  ReadConfig(state, 5, {{"low", &hinge.low_deg}, {"high", &hinge.high_deg}, {"friction", &hinge.friction_nm}});
  CheckRoom(state, ContextOf(state).world.hinge_count(), ContextOf(state).budget.limits().objects, "hinges");
  WarnUnless(state, object->AddHinge(hinge, other));
  return 0;
}

int RemoveHinges(lua_State* state) {
  if (world::Object* object = ObjectArgument(state, 1)) object->RemoveHinges();
  return 0;
}

constexpr Binding kCorePhysicsBindings[] = {
    {"AddHinge", AddHinge, 3, 5, WrongCount::kError},
    {"ApplyAngularImpulse", ApplyAngularImpulse, 2, 2, WrongCount::kIgnored},
    {"ApplyForce", ApplyForce, 2, 2, WrongCount::kIgnored},
    {"ApplyImpulse", ApplyImpulse, 2, 2, WrongCount::kIgnored},
    {"GetMass", GetMass, 1, 1, WrongCount::kIgnored},
    {"RemoveHinges", RemoveHinges, 1, 1, WrongCount::kError},
    {"SetGravity", SetGravity, 2, 2, WrongCount::kIgnored},
    {"SetMass", SetMass, 2, 2, WrongCount::kIgnored},
};

}  // namespace

void BindCorePhysics(lua_State* state) {
  RegisterTable(state, "Core", kCorePhysicsBindings);
}

}  // namespace soarbox::script
