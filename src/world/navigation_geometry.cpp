// SPDX-License-Identifier: BSD-2-Clause
#include "world/navigation_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/state_hash.h"

namespace soarbox::world {
namespace {

constexpr int kSides = 16;
constexpr int kCapRings = 4;

}  // namespace

int NavigationGeometry::AddVertex(Vec3 v) {
  vertices.insert(vertices.end(), {v.x, v.y, v.z});
  return static_cast<int>(vertices.size() / 3) - 1;
}

void NavigationGeometry::AddTriangle(int a, int b, int c) {
  triangles.insert(triangles.end(), {a, b, c});
}

void NavigationGeometry::AddBox(Vec3 center, Vec3 half, Vec3 position, Quat orientation) {
  const int first = static_cast<int>(vertices.size() / 3);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 offset{(corner & 1) ? half.x : -half.x, (corner & 2) ? half.y : -half.y,
                      (corner & 4) ? half.z : -half.z};
    AddVertex(position + Rotate(orientation, center + offset));
  }
  // Bits of a corner's index: 1 is +x, 2 is +y, 4 is +z.
  constexpr int kFaces[6][4] = {{2, 6, 7, 3}, {0, 1, 5, 4}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& face : kFaces) {
    AddTriangle(first + face[0], first + face[1], first + face[2]);
    AddTriangle(first + face[0], first + face[2], first + face[3]);
  }
}

void NavigationGeometry::AddCapsule(float radius_m, float height_m, Vec3 position, Quat orientation) {
  const float straight = std::max(0.0f, height_m / 2 - radius_m);
  const auto add = [&](Vec3 v) { return AddVertex(position + Rotate(orientation, v)); };
  // Rings from the upper pole to the lower one. The two rings at the widest place are the ends of the cylinder.
  std::vector<int> last(kSides, add({0, straight + radius_m, 0}));
  for (int ring = 1; ring <= 2 * kCapRings + 1; ++ring) {
    const bool upper = ring <= kCapRings;
    const int step = upper ? ring : ring - 1;
    const float angle = std::numbers::pi_v<float> * static_cast<float>(step) / (2 * kCapRings);
    const float y = std::cos(angle) * radius_m + (upper ? straight : -straight);
    std::vector<int> next;
    if (ring == 2 * kCapRings + 1) {
      next.assign(kSides, add({0, -straight - radius_m, 0}));
    } else {
      for (int side = 0; side < kSides; ++side) {
        const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(side) / kSides;
        next.push_back(
            add({std::sin(turn) * std::sin(angle) * radius_m, y, std::cos(turn) * std::sin(angle) * radius_m}));
      }
    }
    for (std::size_t side = 0; side < kSides; ++side) {
      const std::size_t beside = (side + 1) % kSides;
      if (next[side] != next[beside]) AddTriangle(last[side], next[side], next[beside]);
      if (last[side] != last[beside]) AddTriangle(last[side], next[beside], last[beside]);
    }
    last = std::move(next);
  }
}

void NavigationGeometry::Bounds(Vec3& min, Vec3& max) const {
  min = max = {};
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    const Vec3 v{vertices[i], vertices[i + 1], vertices[i + 2]};
    min = i == 0 ? v : Vec3{std::min(min.x, v.x), std::min(min.y, v.y), std::min(min.z, v.z)};
    max = i == 0 ? v : Vec3{std::max(max.x, v.x), std::max(max.y, v.y), std::max(max.z, v.z)};
  }
}

std::uint64_t NavigationGeometry::Hash() const {
  StateHash hash;
  for (const float value : vertices) hash.Add(value);
  for (const int index : triangles) hash.Add(static_cast<std::uint64_t>(index));
  return hash.value();
}

}  // namespace soarbox::world
