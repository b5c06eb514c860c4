// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/mesh_data.h"

#include <algorithm>

namespace soarbox::viewer {

void MeshData::Append(const MeshData& other) {
  const auto base = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  indices.reserve(indices.size() + other.indices.size());
  for (const std::uint32_t index : other.indices) indices.push_back(base + index);
}

Bounds BoundsOf(const MeshData& mesh) {
  if (mesh.vertices.empty()) return {};
  Bounds bounds{mesh.vertices[0].position, mesh.vertices[0].position};
  for (const MeshVertex& vertex : mesh.vertices) {
    const world::Vec3 p = vertex.position;
    bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y), std::min(bounds.min.z, p.z)};
    bounds.max = {std::max(bounds.max.x, p.x), std::max(bounds.max.y, p.y), std::max(bounds.max.z, p.z)};
  }
  return bounds;
}

}  // namespace soarbox::viewer
