// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/math.h"

namespace soarbox::world {

/// Conversions between quaternions and the rotation vectors of the sandbox's scripts. A vector of degrees (x, y, z) is
/// the rotation matrix Rx(x) * Ry(y) * Rz(z).

/// Converts a rotation vector to a quaternion.
Quat FromRotationVector(Vec3 degrees);

/// The inverse: y in -90..90, x and z in -180..180; z = 0 in gimbal lock.
Vec3 ToRotationVector(Quat rotation);

/// The result of Core.GetRotation (lua_api.md 5.2): pitch, yaw and roll in degrees, each computed from one rotated
/// axis. In general not the inverse of FromRotationVector.
Vec3 ToPitchYawRoll(Quat rotation);

/// The rotation whose matrix has these columns, which should be orthonormal and right-handed. Other columns give the
/// unit quaternion that the formula yields; degenerate ones give the identity.
Quat FromAxes(Vec3 x, Vec3 y, Vec3 z);

/// The rotation along the shortest arc from direction `from` to direction `to`; lengths do not matter. Opposite
/// directions give a rotation by 180 degrees about an axis perpendicular to `from`. Zero vectors give the identity.
Quat ShortestArc(Vec3 from, Vec3 to);

/// The orientation of an agent: z along forward, x horizontal (up cross z). Returns false and does not change
/// `rotation` if forward is zero, vertical or not finite.
bool FacingAlong(Vec3 forward, Quat& rotation);

Quat Normalized(Quat q);
inline Quat Conjugate(Quat q) {
  return {q.w, -q.x, -q.y, -q.z};
}

bool IsFinite(float value);
bool IsFinite(Vec3 v);
bool IsFinite(Quat q);

}  // namespace soarbox::world
