// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <map>
#include <span>
#include <vector>

#include "script/event_queue.h"
#include "world/collision.h"

namespace soarbox::script {

/// Functions that scripts registered for the collisions of an object (lua_api.md 4.3).
class CollisionCallbacks {
 public:
  /// An object may have several; they are called in the order of their registration.
  void Add(world::EntityId object, LuaMachine& machine, int function);
  std::size_t size() const { return size_; }
  void RemoveObject(world::EntityId object);
  /// Drops all callbacks that this machine keeps. Call it before the machine is destroyed.
  void RemoveMachine(LuaMachine& machine);

  /// For each collision, calls the callbacks of `a`, then those of `b` with the two swapped. An object whose removal
  /// was requested in an earlier callback still receives the remaining collisions of the step.
  void Deliver(std::span<const world::Collision> collisions, const std::function<bool(world::EntityId)>& is_agent,
               const std::function<bool(const LuaMachine&)>& may_run, const EventQueue::OnResult& on_result);

 private:
  struct Callback {
    LuaMachine* machine;
    int function;
  };
  std::map<world::EntityId, std::vector<Callback>> callbacks_;
  std::size_t size_ = 0;
};

}  // namespace soarbox::script
