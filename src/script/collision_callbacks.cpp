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
    if (b_is_agent) {
      PushAgent(state, collision.b);
    } else {
      PushObject(state, collision.b);
    }
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

void CollisionCallbacks::Add(world::EntityId object, LuaMachine& machine, int function) {
  callbacks_[object].push_back({&machine, function});
  ++size_;
}

void CollisionCallbacks::RemoveObject(world::EntityId object) {
  const auto it = callbacks_.find(object);
  if (it == callbacks_.end()) return;
  for (const Callback& callback : it->second) callback.machine->Release(callback.function);
  size_ -= it->second.size();
  callbacks_.erase(it);
}

void CollisionCallbacks::RemoveMachine(LuaMachine& machine) {
  for (auto& [object, callbacks] : callbacks_) {
    size_ -= std::erase_if(callbacks, [&](const Callback& callback) {
      if (callback.machine != &machine) return false;
      machine.Release(callback.function);
      return true;
    });
  }
}

void CollisionCallbacks::Deliver(std::span<const world::Collision> collisions,
                                 const std::function<bool(world::EntityId)>& is_agent,
                                 const std::function<bool(const LuaMachine&)>& may_run,
                                 const EventQueue::OnResult& on_result) {
  if (callbacks_.empty()) return;
  const auto call = [&](const world::Collision& collision) {
    const auto it = callbacks_.find(collision.a);
    if (it == callbacks_.end()) return;
    // A callback may register further callbacks; these receive the next collision.
    const std::vector<Callback> callbacks = it->second;
    for (const Callback& callback : callbacks) {
      if (!may_run(*callback.machine)) continue;
      const auto error = callback.machine->CallKept(callback.function, [&](lua_State* state) {
        PushSandbox(state);
        PushCollision(state, collision, is_agent(collision.b));
        return 2;
      });
      on_result(*callback.machine, error ? &*error : nullptr);
    }
  };
  const std::vector<world::Collision> all(collisions.begin(), collisions.end());
  for (const world::Collision& collision : all) {
    call(collision);
    call(Swapped(collision));
  }
}

}  // namespace soarbox::script
