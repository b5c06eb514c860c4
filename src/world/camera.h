// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/scene_snapshot.h"

namespace soarbox::world {

/// The camera of a world. Scripts set its pose, and the user moves it in the viewer. It looks along its -z axis.
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

  // Setters for scripts. They refuse values that are not finite.
  bool SetPosition(Vec3 position);
  bool SetOrientation(Quat orientation);
  bool SetRotationVector(Vec3 degrees);
  /// Sandbox.SetCameraForward: rotates the camera's +z axis to `direction`, so that it looks along -direction
  /// (lua_api.md 17, quirk 3).
  bool SetBackward(Vec3 direction);

  /// Whether the viewer should keep this pose instead of following agents.
  void SetFixed(bool fixed) { is_fixed_ = fixed; }
  bool is_fixed() const { return is_fixed_; }

  /// Call it when the user has moved the camera to this pose. Does not count as a setter of scripts.
  void FollowViewer(Vec3 position, Quat orientation);

  const CameraSnapshot& state() const { return state_; }
  /// Number of calls of setters by scripts.
  std::uint32_t moves() const { return moves_; }

 private:
  CameraSnapshot state_{{0, 1, 0}, {}, 45};
  std::uint32_t moves_ = 0;
  bool is_fixed_ = false;
};

}  // namespace soarbox::world
