// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"
#include "world/path.h"

namespace soarbox::world {

/// Zero while the predicted position in look_ahead_s is in the path's tube. Otherwise seeks the point of the path that
/// is nearest to the predicted position (Reynolds, 1999, path containment).
Vec3 SteerStayOnPath(const AgentMotion& self, const Path& path, float look_ahead_s);

/// Zero while the predicted position is in the tube and further along the path than self. Otherwise seeks the point of
/// the path that is ahead of self by the distance covered in look_ahead_s. Always follows the path's direction.
Vec3 SteerFollowPath(const AgentMotion& self, const Path& path, float look_ahead_s);

}  // namespace soarbox::world
