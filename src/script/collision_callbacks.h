// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <map>
#include <span>
#include <vector>

#include "script/event_queue.h"
#include "world/collision.h"

namespace soarbox::script {

/// Functions that scripts registered to hear of the collisions of an object (spec 4.3).
class CollisionCallbacks {
 public:
  /// Several per object are kept and called in the order of their registration.
  void Add(world::EntityId object, LuaMachine& machine, int function);
  std::size_t size() const { return size_; }
  void RemoveObject(world::EntityId object);
  /// Drops all callbacks that this machine keeps: it is about to go.
  void RemoveMachine(LuaMachine& machine);

  /// For each collision: the callbacks of a, then those of b with everything swapped. An object that asked for its
  /// removal in an earlier callback still hears of the rest of the step's collisions.
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
