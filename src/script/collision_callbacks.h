// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <span>

#include "script/callbacks.h"
#include "world/collision.h"

namespace soarbox::script {

/// For each collision, calls the functions of `a` (lua_api.md 4.3), then those of `b` with the two swapped. An object
/// whose removal was requested in an earlier function still receives the remaining collisions of the step.
void DeliverCollisions(const Callbacks& callbacks, std::span<const world::Collision> collisions,
                       const std::function<bool(world::EntityId)>& is_agent, const Callbacks::MayRun& may_run,
                       const Callbacks::OnResult& on_result);

}  // namespace soarbox::script
