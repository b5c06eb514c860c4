// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_hull.h"

#include <LinearMath/btConvexHullComputer.h>

#include "world/rotation.h"

namespace soarbox::world {

ConvexHull HullAround(std::span<const Vec3> points) {
  std::vector<float> numbers;
  for (const Vec3& point : points) {
    if (IsFinite(point)) numbers.insert(numbers.end(), {point.x, point.y, point.z});
  }
  ConvexHull hull;
  if (numbers.empty()) return hull;
  btConvexHullComputer computer;
  computer.compute(numbers.data(), 3 * sizeof(float), static_cast<int>(numbers.size() / 3), 0, 0);
  for (int i = 0; i < computer.vertices.size(); ++i) {
    const btVector3& at = computer.vertices[i];
    hull.points.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())});
  }
  const auto number = [](int vertex) { return static_cast<std::uint32_t>(vertex); };
  for (int i = 0; i < computer.edges.size(); ++i) {
    const btConvexHullComputer::Edge& edge = computer.edges[i];
    if (edge.getSourceVertex() < edge.getTargetVertex())
      hull.edges.push_back({number(edge.getSourceVertex()), number(edge.getTargetVertex())});
  }
  for (int i = 0; i < computer.faces.size(); ++i) {
    // A triangle fan from the first corner.
    const btConvexHullComputer::Edge* const first = &computer.edges[computer.faces[i]];
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != first->getSourceVertex();
         edge = edge->getNextEdgeOfFace()) {
      hull.faces.push_back(
          {number(first->getSourceVertex()), number(edge->getSourceVertex()), number(edge->getTargetVertex())});
    }
  }
  return hull;
}

}  // namespace soarbox::world
