// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"

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

constexpr Binding kCorePhysicsBindings[] = {
    {"ApplyAngularImpulse", ApplyAngularImpulse, 2, 2, WrongCount::kIgnored},
    {"ApplyForce", ApplyForce, 2, 2, WrongCount::kIgnored},
    {"ApplyImpulse", ApplyImpulse, 2, 2, WrongCount::kIgnored},
    {"GetMass", GetMass, 1, 1, WrongCount::kIgnored},
    {"SetGravity", SetGravity, 2, 2, WrongCount::kIgnored},
    {"SetMass", SetMass, 2, 2, WrongCount::kIgnored},
};

}  // namespace

void BindCorePhysics(lua_State* state) {
  RegisterTable(state, "Core", kCorePhysicsBindings);
}

}  // namespace soarbox::script
