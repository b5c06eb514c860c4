// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "world/math.h"

namespace soarbox::viewer {

/// The vertex format of the surface shader: plain data that is computed once and uploaded once (mesh_library.h).
///
/// Counter-clockwise seen from outside. A vertex has three paint values in addition to its geometry, so that one
/// material and one draw call can show a body with a dark, glossy visor.
struct MeshVertex {
  world::Vec3 position;
  world::Vec3 normal;
  float u = 0, v = 0;
  float tint = 1;   ///< 1: the material's colour, 0: the dark trim colour.
  float light = 1;  ///< Multiplies the colour; below 1 in crevices.
  float gloss = 0;  ///< Added to the material's gloss, 0..1.
};

struct MeshData {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::string material = "White";  ///< Used if the drawable has no material name.

  void AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
  void AddQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    AddTriangle(a, b, c);
    AddTriangle(a, c, d);
  }
  void Append(const MeshData& other);
};

/// Smallest and largest corner of the vertices; both zero for an empty mesh.
struct Bounds {
  world::Vec3 min, max;
};
Bounds BoundsOf(const MeshData& mesh);

}  // namespace soarbox::viewer
