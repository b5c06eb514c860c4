// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// The shapes that scripts create by size. All sizes in m; sizes that are negative or not finite count as 0.

/// An axis-aligned box from min to max with chamfered edges; the chamfer shrinks on thin boxes. Each face runs from
/// uv (0, 0) to (repeats_u, repeats_v); with `metric_uv` a texture repeats every metre instead.
struct BoxStyle {
  float chamfer_m = 0.03f;
  float repeats_u = 1, repeats_v = 1;
  bool metric_uv = false;
};
MeshData BoxMesh(world::Vec3 min, world::Vec3 max, const BoxStyle& style = {});

/// Upright, centred on the origin; `height_m` includes both caps.
MeshData CapsuleMesh(float radius_m, float height_m);

/// The body of an agent within the same capsule: a rounded torso, a groove for a neck, a domed head, and a dark visor
/// that faces +z. Coarse ones are for agents that are small in the picture.
enum class AgentDetail : std::uint8_t { kFine, kMiddle, kCoarse, kTiny };
MeshData AgentMesh(float radius_m, float height_m, AgentDetail detail = AgentDetail::kFine);

/// Upright, centred on the origin, with rounded rims.
MeshData CylinderMesh(float radius_m, float height_m);

MeshData SphereMesh(float radius_m);

/// While one lives, what this thread makes of round shapes has fewer faces: for pictures that the processor draws.
class CoarseShapes {
 public:
  CoarseShapes();
  ~CoarseShapes();
  CoarseShapes(const CoarseShapes&) = delete;
  CoarseShapes& operator=(const CoarseShapes&) = delete;

 private:
  bool before_;
};
/// Of how many pieces something round is made that usually has `fine` of them.
int PiecesOf(int fine);

/// Horizontal, facing up, centred on the origin.
MeshData PlaneMesh(float size_x_m, float size_z_m, float repeats_u, float repeats_v);

}  // namespace soarbox::viewer
