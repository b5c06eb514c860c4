// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/scene_snapshot.h"

namespace soarbox::world {

/// The one camera: scripts give it orders, the viewer's free look moves it, both see the same pose. Looks along its -z.
class Camera {
 public:
  Vec3 Position() const { return state_.position; }
  Quat Orientation() const { return state_.orientation; }
  /// The viewing direction.
  Vec3 Forward() const { return Rotate(state_.orientation, {0, 0, -1}); }
  Vec3 Left() const { return Rotate(state_.orientation, {-1, 0, 0}); }
  Vec3 Up() const { return Rotate(state_.orientation, {0, 1, 0}); }
  /// Degrees; the sandbox's rotation vector.
  Vec3 RotationVector() const;

  // Orders of scripts. Values that are not finite are refused.
  bool SetPosition(Vec3 position);
  bool SetOrientation(Quat orientation);
  bool SetRotationVector(Vec3 degrees);
  /// Sandbox.SetCameraForward: takes camera-space +z to direction, so that the camera looks along -direction (quirk 3).
  bool SetBackward(Vec3 direction);

  /// Whether the viewer should stay with it rather than follow agents.
  void SetFixed(bool fixed) { is_fixed_ = fixed; }
  bool is_fixed() const { return is_fixed_; }

  /// The viewer reports where its free look has moved the camera; not an order.
  void FollowViewer(Vec3 position, Quat orientation);

  const CameraSnapshot& state() const { return state_; }
  /// Counts the orders of scripts.
  std::uint32_t moves() const { return moves_; }

 private:
  CameraSnapshot state_{{0, 1, 0}, {}, 45};
  std::uint32_t moves_ = 0;
  bool is_fixed_ = false;
};

}  // namespace soarbox::world
