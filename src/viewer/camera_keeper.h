// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "world/math.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// Something that the picture should show.
struct FramedBody {
  world::Vec3 position;  ///< Of its middle.
  world::Vec3 velocity;  ///< m/s
  float radius_m = 0.35f, height_m = 1.75f;
};

/// The nearest pose with this orientation that shows all the bodies.
world::CameraSnapshot FramingPose(std::span<const FramedBody> bodies, world::Quat orientation, float vertical_fov_deg,
                                  float aspect);

/// Decides where the camera has to go so that what matters stays in the picture, and otherwise lets it rest.
///
/// It asks for a new place only when somebody is about to leave the picture, or when the picture has been far too wide
/// for a while: small movements move nothing. It never turns the camera. Pure arithmetic, no drawing.
class CameraKeeper {
 public:
  /// Agents come first: places (of waypoints, regions, items) join in as long as agents stay large enough.
  /// `goal`: where the camera is or is on its way to. Returns the new goal; none: the present one is good.
  /// Then scenery does.
  std::optional<world::CameraSnapshot> Follow(std::span<const FramedBody> agents, std::span<const world::Vec3> places,
                                              const world::CameraSnapshot& goal, float aspect, float seconds,
                                              std::span<const FramedBody> scenery = {});
  /// Forgets how long the picture has been too wide.
  void Begin() { wide_s_ = 0; }

 private:
  float wide_s_ = 0;
};

/// Where agents have been in the last seconds of the user's clock. In a world that runs fast, this says better than
/// their velocity where they will be: they turn round many times while the camera moves once.
class RecentGround {
 public:
  void Note(std::span<const FramedBody> agents, float seconds);
  void Forget() { spans_.clear(); }
  /// Adds its corners to what is to be in the picture.
  void AddTo(std::vector<FramedBody>& bodies) const;

 private:
  struct Span {
    world::Vec3 low, high;
    float age_s = 0;
  };
  std::deque<Span> spans_;  ///< The newest last.
};

/// Those of the places that can be shown with the agents without making them too small; and of scenery, all or nothing.
std::vector<FramedBody> WithPlaces(std::span<const FramedBody> agents, std::span<const world::Vec3> places,
                                   world::Quat orientation, float vertical_fov_deg, float aspect,
                                   std::span<const FramedBody> scenery = {});

/// What stands about between the agents and beside them and would look odd if the picture's edge cut it: walls, crates
/// and figures, as the corners of their ground. Of a wide landscape nothing.
std::vector<FramedBody> SceneryAround(const world::SceneSnapshot& scene, std::span<const world::Vec3> places);

}  // namespace soarbox::viewer
