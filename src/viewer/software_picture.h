// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "picture/image.h"
#include "viewer/images.h"
#include "viewer/skin_mesh.h"
#include "viewer/software_raster.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// Draws scenes on the processor, without a display and without graphics libraries: the window's shapes and colours, a
/// directional light with shadows, debug lines, and names above heads. It draws no textures, particles or panels.
class SoftwarePictures {
 public:
  SoftwarePictures(int width_px, int height_px);

  picture::Image Draw(const world::SceneSnapshot& scene, const SoftwareCamera& camera);

 private:
  struct Shape {
    SkinMesh mesh;                         ///< Without `skin` if it has no skeleton.
    std::vector<world::BonePose> to_bind;  ///< Of its skeleton.
  };
  /// A drawable in world space, with the vertices of its mesh.
  struct Placed {
    const MeshData* mesh = nullptr;
    std::vector<world::Vec3> at, normal;
    std::vector<picture::Ink> ink;
    float glow = 0;
    bool is_clear = false;
  };

  const Shape& ShapeOf(const world::DrawableSnapshot& drawable, bool agent_body);
  Placed Place(const world::DrawableSnapshot& drawable, const world::AgentSnapshot* agent);
  std::vector<Placed> PlaceAll(const world::SceneSnapshot& scene);
  void AddBackdrop(std::vector<Placed>& all);
  void DrawPlaced(const Placed& placed);
  void SeeFromSun(const std::vector<Placed>& all, const SoftwareCamera& camera);
  bool IsShadowed(world::Vec3 point) const;
  void Shade(float ground_m);
  void DrawLines(const world::SceneSnapshot& scene);
  void WriteNames(const world::SceneSnapshot& scene, picture::Image& image) const;

  SoftwareRaster raster_;  ///< Twice the size of the picture, for smooth edges.
  SoftwareRaster sun_;     ///< Depth as seen from the light.
  SoftwareCamera from_sun_;
  Image cloths_;
  std::map<std::string, Shape> shapes_;
};

/// Returns a camera that sees all of these places, from above and from the front. `is_plan`: straight down with
/// parallel rays; x is to the right and z down, as on the map of a report.
SoftwareCamera CameraOver(const std::vector<world::Vec3>& places, float aspect, bool is_plan);

}  // namespace soarbox::viewer
