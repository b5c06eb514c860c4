// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// The shapes that scripts create with a size. All sizes are in m; negative sizes and sizes that are not finite count
/// as 0.

/// An axis-aligned box from min to max with chamfered edges; the chamfer is smaller on thin boxes. Each face has the
/// texture coordinates (0, 0) to (repeats_u, repeats_v). With `metric_uv`, a texture repeats every metre instead.
struct BoxStyle {
  float chamfer_m = 0.03f;
  float repeats_u = 1, repeats_v = 1;
  bool metric_uv = false;
};
MeshData BoxMesh(world::Vec3 min, world::Vec3 max, const BoxStyle& style = {});

/// Upright, centred on the origin; `height_m` includes both caps.
MeshData CapsuleMesh(float radius_m, float height_m);

/// The body of an agent in the same capsule: a rounded torso, a groove as the neck, a domed head, and a dark visor that
/// faces +z. Coarse ones are for agents that are small in the picture.
enum class AgentDetail : std::uint8_t { kFine, kMiddle, kCoarse, kTiny };
MeshData AgentMesh(float radius_m, float height_m, AgentDetail detail = AgentDetail::kFine);

/// Upright, centred on the origin, with rounded rims.
MeshData CylinderMesh(float radius_m, float height_m);

MeshData SphereMesh(float radius_m);

/// While such an object exists, round shapes that this thread builds have fewer faces; used for software pictures.
class CoarseShapes {
 public:
  CoarseShapes();
  ~CoarseShapes();
  CoarseShapes(const CoarseShapes&) = delete;
  CoarseShapes& operator=(const CoarseShapes&) = delete;

 private:
  bool before_;
};
/// Returns the number of segments of a round shape that normally has `fine` segments.
int PiecesOf(int fine);

/// Horizontal, facing up, centred on the origin.
MeshData PlaneMesh(float size_x_m, float size_z_m, float repeats_u, float repeats_v);

}  // namespace soarbox::viewer
