// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "picture/image.h"
#include "world/math.h"

namespace soarbox::viewer {

/// Where a software picture is taken from.
struct SoftwareCamera {
  world::Vec3 eye{0, 20, -20};
  world::Vec3 ahead{0, -0.7f, 0.7f};  ///< A unit vector.
  world::Vec3 up{0, 1, 0};            ///< Not along `ahead`.
  float vertical_fov_deg = 45;
  float high_m = 0;  ///< Greater than 0: parallel rays, for plans; this height of the world fills the picture.
};

/// Where a point is in the picture.
struct Projected {
  float x = 0, y = 0;  ///< In pixels.
  float depth = 0;     ///< In m along the view; with parallel rays, too.
  float size_px = 0;   ///< How large 1 m is there.
};

/// Draws triangles into an image with a depth buffer, on the processor.
class SoftwareRaster {
 public:
  SoftwareRaster(int width, int height);

  void Begin(const SoftwareCamera& camera);
  /// Nothing if the point is behind the camera.
  std::optional<Projected> Project(world::Vec3 point) const;
  /// The way that is seen at the middle of a pixel; a unit vector.
  world::Vec3 RayOf(int x, int y) const;
  /// The nearest opaque point at a pixel; nothing if there is none.
  std::optional<world::Vec3> WorldAt(int x, int y) const;

  struct Corner {
    world::Vec3 at;
    picture::Ink ink;
  };
  /// Its colours are mixed between its corners. Opaque ones hide what is farther away; others do not.
  void Triangle(const Corner& a, const Corner& b, const Corner& c);

  picture::Image& image() { return image_; }
  /// The depth of the nearest opaque surface at a pixel; infinite if there is none, or no such pixel.
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
  std::vector<float> nearness_;  ///< 1 / depth (or its negative with parallel rays) of each pixel.
  SoftwareCamera camera_;
  world::Vec3 right_, up_;
  float scale_px_ = 1;  ///< Pixels per m at a depth of 1 m; with parallel rays at each depth.
};

}  // namespace soarbox::viewer
