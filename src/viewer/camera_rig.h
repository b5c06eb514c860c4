// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "viewer/camera_keeper.h"
#include "world/math.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// What the user holds down and how the mouse moved since the last frame.
struct CameraInput {
  float forward = 0, left = 0, up = 0;  ///< -1..1
  bool fast = false;
  bool looking = false;              ///< The right button is held: the mouse turns the camera.
  bool panning = false;              ///< The middle button is held: the mouse drags the picture.
  float mouse_dx = 0, mouse_dy = 0;  ///< px
  float wheel = 0;                   ///< Notches, positive away from the user.
  world::Vec3 towards = {};          ///< What is under the cursor lies that way; zero: the middle of the picture.
};

enum class CameraMode : std::uint8_t {
  kFree,    ///< Flies where the user steers it.
  kOrbit,   ///< Circles round a point.
  kFollow,  ///< Circles round an agent and goes with it.
  kEyes,    ///< Looks out of an agent's eyes.
  kMap,     ///< Looks straight down; north (-z) is up.
};

/// The camera: a mode, what the mode needs, and a smooth way from one view to the next. It never rolls by itself. Pure
/// arithmetic, no drawing.
class CameraRig {
 public:
  /// Jumps there and flies freely: where a script put the camera. A pose that is no number is ignored.
  void MoveTo(const world::CameraSnapshot& pose);

  /// Changes the mode; the picture glides over. `agent`: the selected one, or null; without it kFollow and kEyes are
  /// refused (false) and kOrbit circles round what is in the middle of the picture.
  bool SetMode(CameraMode mode, const world::AgentSnapshot* agent);
  CameraMode mode() const { return mode_; }
  /// The agent that it goes with or looks out of; 0: none.
  std::uint32_t agent() const;

  /// From now on it stays where all it is told of by Keep is in the picture, until the user steers it, another mode is
  /// chosen or MoveTo is called. Freely flying and on the map only.
  void BeginKeeping();
  bool keeps() const { return keeps_; }
  /// What is to stay in the picture of that shape (width over height); before each Update. Does nothing unless keeps().
  void Keep(std::span<const FramedBody> agents, std::span<const world::Vec3> places, float aspect, float seconds,
            std::span<const FramedBody> scenery = {});

  /// Glides to where all these agents fill the picture of that shape (width over height), in the present mode if that
  /// can be. `best_side`: from where they are seen best, else from the side that the camera is on now. Places join in
  /// as long as agents stay large enough. `from_above`: walls stand between them, so it looks down steeply.
  void Frame(std::span<const world::AgentSnapshot* const> agents, float aspect, bool best_side,
             std::span<const world::Vec3> places = {}, bool from_above = false,
             std::span<const FramedBody> scenery = {});

  /// Glides towards the place on the ground that lies that way from the camera, and brings it to the middle of the
  /// picture; nothing happens above the horizon.
  void GoTo(world::Vec3 way);

  /// Advances by `seconds` of the user's time. `agent`: the one of agent() as it stands now; null if it is gone, which
  /// ends modes that need it. `height_px`: of the picture.
  void Update(const CameraInput& input, float seconds, const world::AgentSnapshot* agent, float height_px);
  /// Ends the glide at once; for pictures.
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
  /// How far the ground or the pivot is along the view: what a step of the wheel or a dragged pixel is measured by.
  float Reach() const;
  float ReachAlong(world::Vec3 way) const;
  /// The user takes the camera: it stays where the picture shows it.
  void StopKeeping();
  /// Brings what is shown nearer to the pose, without ever jumping.
  void Approach(float seconds);
  /// Changes the distance from the pivot.
  void Zoom(const CameraInput& input, float nearest_m);

  CameraMode mode_ = CameraMode::kFree;
  world::CameraSnapshot pose_;   ///< Where the mode wants the camera.
  world::CameraSnapshot shown_;  ///< Where it is, on the way from `from_`.
  world::CameraSnapshot from_;
  float on_the_way_ = 1;  ///< 0..1
  world::Vec3 velocity_;
  world::Vec3 pivot_;   ///< Orbit, follow; the point below on the map.
  float distance_ = 8;  ///< From the pivot.
  std::uint32_t agent_ = 0;
  float look_yaw_ = 0, look_pitch_ = 0;  ///< Eyes: away from where the agent faces, in rad.
  bool keeps_ = false;
  CameraKeeper keeper_;
  world::Vec3 drift_;  ///< m/s, of what is shown while it keeps.
};

}  // namespace soarbox::viewer
