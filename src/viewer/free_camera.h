// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/math.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// What the user holds down and how the mouse moved since the last frame.
struct CameraInput {
  float forward = 0, left = 0, up = 0;  ///< -1..1
  bool fast = false;
  bool looking = false;              ///< The right button is held: the mouse turns the camera.
  float mouse_dx = 0, mouse_dy = 0;  ///< px
  float wheel = 0;                   ///< Notches, positive away from the user.
};

/// The camera as the user flies it (lua_api.md 14): it glides, turns about the world's y axis and never rolls by
/// itself. When it follows a body it circles it at a distance instead. Pure arithmetic, no drawing.
class FreeCamera {
 public:
  /// Jumps there: where a script or F1 put the camera. Ends following. A pose that is no number is ignored.
  void MoveTo(const world::CameraSnapshot& pose);

  /// Advances by `seconds` of the user's time.
  void Update(const CameraInput& input, float seconds);

  /// Circles `target` from now on; call it each frame with the body's position. Moving by keys ends it.
  void Follow(world::Vec3 target);
  void StopFollowing() { following_ = false; }
  bool following() const { return following_; }

  const world::CameraSnapshot& pose() const { return pose_; }
  world::Vec3 forward() const { return Rotate(pose_.orientation, {0, 0, -1}); }
  /// m/s without Shift; the wheel changes it.
  float speed() const { return speed_; }

 private:
  void Turn(float dx, float dy);

  world::CameraSnapshot pose_;
  world::Vec3 velocity_;
  world::Vec3 target_;
  float speed_ = 5;
  float distance_ = 8;
  bool following_ = false;
};

}  // namespace soarbox::viewer
