// SPDX-License-Identifier: BSD-2-Clause
#include "script/collision_callbacks.h"

#include <lua.hpp>

namespace soarbox::script {
namespace {

world::Collision Swapped(const world::Collision& collision) {
  return {collision.b, collision.a, collision.point_b, collision.point_a, -collision.normal_on_b};
}

void PushCollision(lua_State* state, const world::Collision& collision, bool b_is_agent) {
  lua_createtable(state, 0, 5);
  PushObject(state, collision.a);
  lua_setfield(state, -2, "objectA");
  if (collision.b != world::kNoEntity) {
    PushHandle(state, {b_is_agent ? ValueKind::kAgent : ValueKind::kObject, Number(collision.b)});
    lua_setfield(state, -2, "objectB");
  }
  PushVector(state, collision.point_a);
  lua_setfield(state, -2, "pointA");
  PushVector(state, collision.point_b);
  lua_setfield(state, -2, "pointB");
  PushVector(state, collision.normal_on_b);
  lua_setfield(state, -2, "normalOnB");
}

}  // namespace

void DeliverCollisions(const Callbacks& callbacks, std::span<const world::Collision> collisions,
                       const std::function<bool(world::EntityId)>& is_agent, const Callbacks::MayRun& may_run,
                       const Callbacks::OnResult& on_result) {
  if (callbacks.size() == 0) return;
  const std::vector<world::Collision> all(collisions.begin(), collisions.end());
  for (const world::Collision& collision : all) {
    for (const world::Collision& seen : {collision, Swapped(collision)}) {
      callbacks.Call(Number(seen.a), may_run, on_result, [&](lua_State* state, Handle) {
        PushSandbox(state);
        PushCollision(state, seen, is_agent(seen.b));
        return 2;
      });
    }
  }
}

}  // namespace soarbox::script
