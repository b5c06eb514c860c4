// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"
#include "world/path.h"

namespace soarbox::world {

/// Zero while the place that self will reach in look_ahead_s lies in the path's tube, else seeks the nearest point of
/// the path to that place (Reynolds, 1999, path containment).
Vec3 SteerStayOnPath(const AgentMotion& self, const Path& path, float look_ahead_s);

/// Zero while that place lies in the tube and further along the path than self, else seeks the point of the path that
/// is look_ahead_s of self's speed ahead of self. Always in the path's direction.
Vec3 SteerFollowPath(const AgentMotion& self, const Path& path, float look_ahead_s);

}  // namespace soarbox::world
