// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/math.h"

namespace soarbox::world {

/// Conversions between quaternions and the rotation vectors of the sandbox's scripts: degrees (x, y, z) that stand for
/// the matrix Rx(x) * Ry(y) * Rz(z).

/// The rotation that a rotation vector stands for.
Quat FromRotationVector(Vec3 degrees);

/// The inverse: y in -90..90, x and z in -180..180; z = 0 in gimbal lock.
Vec3 ToRotationVector(Quat rotation);

/// What Core.GetRotation reports (spec 5.2): pitch, yaw, roll in degrees, each read off one rotated axis. Not in
/// general the inverse of FromRotationVector.
Vec3 ToPitchYawRoll(Quat rotation);

/// The rotation whose matrix has these columns. They should be orthonormal and right-handed; others give the nearest
/// unit quaternion that the formula yields, and degenerate ones the identity.
Quat FromAxes(Vec3 x, Vec3 y, Vec3 z);

/// The rotation along the shortest arc that takes direction from to direction to; lengths do not matter. Opposite
/// directions turn 180 degrees about an axis perpendicular to from. Zero vectors give the identity.
Quat ShortestArc(Vec3 from, Vec3 to);

/// Agents: z along forward, x horizontal (up cross z). False, and rotation untouched, if forward is zero, vertical or
/// not finite.
bool FacingAlong(Vec3 forward, Quat& rotation);

Quat Normalized(Quat q);
inline Quat Conjugate(Quat q) {
  return {q.w, -q.x, -q.y, -q.z};
}

bool IsFinite(float value);
bool IsFinite(Vec3 v);
bool IsFinite(Quat q);

}  // namespace soarbox::world
