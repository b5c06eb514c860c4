// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "world/math.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// A body that the picture should show.
struct FramedBody {
  world::Vec3 position;  ///< Of the body's centre.
  world::Vec3 velocity;  ///< m/s
  float radius_m = 0.35f, height_m = 1.75f;
};

/// Returns the nearest camera pose with this orientation that shows all the bodies.
world::CameraSnapshot FramingPose(std::span<const FramedBody> bodies, world::Quat orientation, float vertical_fov_deg,
                                  float aspect);

/// Decides where the camera must move so that agents stay in the picture.
///
/// It returns a new goal only when an agent is about to leave the picture, or when the picture has been far too wide
/// for some time. Small movements do not move the camera. It never turns the camera. It only computes; it draws
/// nothing.
class CameraKeeper {
 public:
  /// Agents have priority. Places (waypoints, regions, items) are added as long as agents stay large enough, then
  /// scenery. `goal` is the pose that the camera has or moves to. Returns the new goal, or nothing if `goal` is still
  /// good.
  std::optional<world::CameraSnapshot> Follow(std::span<const FramedBody> agents, std::span<const world::Vec3> places,
                                              const world::CameraSnapshot& goal, float aspect, float seconds,
                                              std::span<const FramedBody> scenery = {});
  /// Resets the time for which the picture has been too wide.
  void Begin() { wide_s_ = 0; }

 private:
  float wide_s_ = 0;
};

/// The area in which agents have been in the last seconds of wall time. In a world that runs fast, this predicts their
/// positions better than their velocities, because they turn many times while the camera moves once.
class RecentGround {
 public:
  void Note(std::span<const FramedBody> agents, float seconds);
  void Forget() { spans_.clear(); }
  /// Adds the corners of the area to the bodies that the picture should show.
  void AddTo(std::vector<FramedBody>& bodies) const;

 private:
  struct Span {
    world::Vec3 low, high;
    float age_s = 0;
  };
  std::deque<Span> spans_;  ///< Newest last.
};

/// Returns the agents, the places that can be shown with them without making them too small, and either all of
/// `scenery` or none of it.
std::vector<FramedBody> WithPlaces(std::span<const FramedBody> agents, std::span<const world::Vec3> places,
                                   world::Quat orientation, float vertical_fov_deg, float aspect,
                                   std::span<const FramedBody> scenery = {});

/// Returns walls, crates and figures between and next to the agents, as the corners of their bases. They would look odd
/// if the edge of the picture cut them. Returns nothing for a wide landscape.
std::vector<FramedBody> SceneryAround(const world::SceneSnapshot& scene, std::span<const world::Vec3> places);

}  // namespace soarbox::viewer
