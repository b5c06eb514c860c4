// SPDX-License-Identifier: BSD-2-Clause
#include "world/camera.h"

#include "world/rotation.h"

namespace soarbox::world {

Vec3 Camera::RotationVector() const {
  return ToRotationVector(state_.orientation);
}

bool Camera::SetPosition(Vec3 position) {
  if (!IsFinite(position)) return false;
  state_.position = position;
  ++moves_;
  return true;
}

bool Camera::SetOrientation(Quat orientation) {
  if (!IsFinite(orientation)) return false;
  state_.orientation = Normalized(orientation);
  ++moves_;
  return true;
}

bool Camera::SetRotationVector(Vec3 degrees) {
  return IsFinite(degrees) && SetOrientation(FromRotationVector(degrees));
}

bool Camera::SetBackward(Vec3 direction) {
  if (!IsFinite(direction) || LengthSquared(direction) == 0) return false;
  return SetOrientation(ShortestArc({0, 0, 1}, direction));
}

void Camera::FollowViewer(Vec3 position, Quat orientation) {
  if (!IsFinite(position) || !IsFinite(orientation)) return;
  state_.position = position;
  state_.orientation = Normalized(orientation);
}

}  // namespace soarbox::world
