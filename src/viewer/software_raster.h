// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "picture/image.h"
#include "world/math.h"

namespace soarbox::viewer {

/// The camera of a software picture.
struct SoftwareCamera {
  world::Vec3 eye{0, 20, -20};
  world::Vec3 ahead{0, -0.7f, 0.7f};  ///< A unit vector.
  world::Vec3 up{0, 1, 0};            ///< Not parallel to `ahead`.
  float vertical_fov_deg = 45;
  float high_m = 0;  ///< Greater than 0: parallel rays, for plans; this height in m fills the picture.
};

/// Position of a point in the picture.
struct Projected {
  float x = 0, y = 0;  ///< In pixels.
  float depth = 0;     ///< In m along the view direction; also with parallel rays.
  float size_px = 0;   ///< Size of 1 m at this depth.
};

/// Rasterizes triangles into an image with a depth buffer, on the processor.
class SoftwareRaster {
 public:
  SoftwareRaster(int width, int height);

  void Begin(const SoftwareCamera& camera);
  /// Nothing if the point is behind the camera.
  std::optional<Projected> Project(world::Vec3 point) const;
  /// Unit vector of the ray through the centre of a pixel.
  world::Vec3 RayOf(int x, int y) const;
  /// Returns the nearest opaque point at a pixel; nothing if there is none.
  std::optional<world::Vec3> WorldAt(int x, int y) const;

  struct Corner {
    world::Vec3 at;
    picture::Ink ink;
  };
  /// Interpolates the colours of the corners. An opaque triangle hides what is further away; others do not.
  void Triangle(const Corner& a, const Corner& b, const Corner& c);

  picture::Image& image() { return image_; }
  /// Returns the depth of the nearest opaque surface at a pixel; infinite if there is none, or if the pixel does not
  /// exist.
  float DepthAt(int x, int y) const;

 private:
  struct Point {
    world::Vec3 at;  ///< To the right, up, ahead of the camera, in m.
    picture::Ink ink;
  };
  Point SeenFrom(const Corner& corner) const;
  Projected OnPicture(world::Vec3 seen) const;
  void Fill(const Point& a, const Point& b, const Point& c);

  picture::Image image_;
  std::vector<float> nearness_;  ///< Of each pixel: 1 / depth; with parallel rays, -depth.
  SoftwareCamera camera_;
  world::Vec3 right_, up_;
  float scale_px_ = 1;  ///< Pixels per m at a depth of 1 m; with parallel rays, at any depth.
};

}  // namespace soarbox::viewer
