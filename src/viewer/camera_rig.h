// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "viewer/camera_keeper.h"
#include "world/math.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// Keys and buttons that the user holds down, and the mouse movement since the last frame.
struct CameraInput {
  float forward = 0, left = 0, up = 0;  ///< -1..1
  bool fast = false;
  bool looking = false;              ///< The right button is held: the mouse turns the camera.
  bool panning = false;              ///< The middle button is held: the mouse moves the picture.
  float mouse_dx = 0, mouse_dy = 0;  ///< px
  float wheel = 0;                   ///< Notches, positive away from the user.
  world::Vec3 towards = {};          ///< Direction to the point under the cursor; zero: the middle of the picture.
};

enum class CameraMode : std::uint8_t {
  kFree,    ///< The user moves it.
  kOrbit,   ///< Circles around a point.
  kFollow,  ///< Circles around an agent and moves with it.
  kEyes,    ///< Shows what an agent sees.
  kMap,     ///< Looks straight down; north (-z) is up.
};

/// The camera: a mode, the state of the mode, and a smooth transition from one pose to the next. It never rolls by
/// itself. It only computes; it draws nothing.
class CameraRig {
 public:
  /// Jumps to a pose that a script requested and changes to kFree. Ignores a pose that is not finite.
  void MoveTo(const world::CameraSnapshot& pose);

  /// Changes the mode with a smooth transition. `agent` is the selected agent or null. Without an agent, kFollow and
  /// kEyes are refused (returns false), and kOrbit circles around the point in the middle of the picture.
  bool SetMode(CameraMode mode, const world::AgentSnapshot* agent);
  CameraMode mode() const { return mode_; }
  /// The agent of kFollow and kEyes; 0: none.
  std::uint32_t agent() const;

  /// From now on the camera keeps everything that Keep() receives in the picture, until the user moves the camera, the
  /// mode changes, or MoveTo() is called. Only in kFree and kMap.
  void BeginKeeping();
  bool keeps() const { return keeps_; }
  /// Sets what must stay in the picture. `aspect` is width divided by height. Call it before each Update. Does nothing
  /// unless keeps().
  void Keep(std::span<const FramedBody> agents, std::span<const world::Vec3> places, float aspect, float seconds,
            std::span<const FramedBody> scenery = {});

  /// Moves smoothly to a pose in which all these agents fill the picture, in the current mode if possible. `aspect` is
  /// width divided by height. `best_side`: from the direction that shows them best, else from the camera's current
  /// direction. Places are added as long as agents stay large enough. `from_above`: walls separate the agents, so the
  /// camera looks down steeply.
  void Frame(std::span<const world::AgentSnapshot* const> agents, float aspect, bool best_side,
             std::span<const world::Vec3> places = {}, bool from_above = false,
             std::span<const FramedBody> scenery = {});

  /// Moves smoothly towards the point on the ground in this direction and brings it to the middle of the picture. Does
  /// nothing above the horizon, if the point is more than 400 m away, or in kEyes.
  void GoTo(world::Vec3 way);

  /// Advances by `seconds` of wall time. `agent` is the current state of agent(); null if it no longer exists, which
  /// ends modes that need it. `height_px` is the height of the picture.
  void Update(const CameraInput& input, float seconds, const world::AgentSnapshot* agent, float height_px);
  /// Ends the transition at once; used for pictures in files.
  void Arrive();

  const world::CameraSnapshot& pose() const { return shown_; }
  world::Vec3 forward() const { return Rotate(shown_.orientation, {0, 0, -1}); }

 private:
  void Turn(float dx, float dy);
  void Glide();
  void Fly(const CameraInput& input, float seconds);
  void Circle(const CameraInput& input, float seconds, float height_px);
  void Look(const CameraInput& input, float seconds, const world::AgentSnapshot& agent);
  void Hover(const CameraInput& input, float seconds, float height_px);
  /// Distance to the ground or the pivot along the view. A step of the wheel and a dragged pixel are scaled by it.
  float Reach() const;
  float ReachAlong(world::Vec3 way) const;
  /// Stops keeping because the user moves the camera. The camera stays where it is shown.
  void StopKeeping();
  /// Moves the shown pose towards `pose_`, without jumps.
  void Approach(float seconds);
  /// Changes the distance from the pivot.
  void Zoom(const CameraInput& input, float nearest_m);

  CameraMode mode_ = CameraMode::kFree;
  world::CameraSnapshot pose_;   ///< The pose that the mode requests.
  world::CameraSnapshot shown_;  ///< The pose that is shown, between `from_` and `pose_`.
  world::CameraSnapshot from_;
  float on_the_way_ = 1;  ///< 0..1
  world::Vec3 velocity_;
  world::Vec3 pivot_;   ///< Of kOrbit and kFollow; in kMap the point below the camera.
  float distance_ = 8;  ///< From the pivot.
  std::uint32_t agent_ = 0;
  float look_yaw_ = 0, look_pitch_ = 0;  ///< kEyes: relative to the direction that the agent faces, in rad.
  bool keeps_ = false;
  CameraKeeper keeper_;
  world::Vec3 drift_;  ///< m/s, velocity of the shown pose while it keeps.
};

}  // namespace soarbox::viewer
