// SPDX-License-Identifier: BSD-2-Clause
#include "world/debug_draw.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "world/rotation.h"

namespace soarbox::world {
namespace {

constexpr float kFillAlpha = 0.5f;

struct UnitSphere {
  std::vector<std::array<Vec3, 3>> faces;
  std::vector<std::pair<Vec3, Vec3>> edges;
};

// An icosahedron with each face split into four: 42 vertices, 80 faces, 120 edges.
UnitSphere MakeUnitSphere() {
  const float g = std::numbers::phi_v<float>;
  const std::array<Vec3, 12> corners{{{-1, g, 0},
                                      {1, g, 0},
                                      {-1, -g, 0},
                                      {1, -g, 0},
                                      {0, -1, g},
                                      {0, 1, g},
                                      {0, -1, -g},
                                      {0, 1, -g},
                                      {g, 0, -1},
                                      {g, 0, 1},
                                      {-g, 0, -1},
                                      {-g, 0, 1}}};
  // The edges of this icosahedron have length 2. Three vertices at this distance from each other form a face.
  const auto adjacent = [&corners](std::size_t a, std::size_t b) {
    return std::abs(Distance(corners[a], corners[b]) - 2.0f) < 0.01f;
  };
  UnitSphere sphere;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      if (!adjacent(i, j)) continue;
      const Vec3 a = Normalized(corners[i]), b = Normalized(corners[j]), ab = Normalized(a + b);
      sphere.edges.emplace_back(a, ab);
      sphere.edges.emplace_back(ab, b);
      for (std::size_t k = j + 1; k < corners.size(); ++k) {
        if (!adjacent(i, k) || !adjacent(j, k)) continue;
        const Vec3 c = Normalized(corners[k]), bc = Normalized(b + c), ca = Normalized(c + a);
        sphere.faces.push_back({a, ab, ca});
        sphere.faces.push_back({b, bc, ab});
        sphere.faces.push_back({c, ca, bc});
        sphere.faces.push_back({ab, bc, ca});
        sphere.edges.emplace_back(ab, bc);
        sphere.edges.emplace_back(bc, ca);
        sphere.edges.emplace_back(ca, ab);
      }
    }
  }
  return sphere;
}

std::vector<Vec3> MakeUnitCircle() {
  std::vector<Vec3> corners;
  for (int i = 1; i <= static_cast<int>(kLinesOfCircle); ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(kLinesOfCircle);
    corners.push_back({std::cos(angle), 0, std::sin(angle)});
  }
  return corners;
}

Color Opaque(Vec3 color) {
  return {color.x, color.y, color.z, 1};
}

}  // namespace

void DebugDraw::Line(Vec3 from, Vec3 to, Vec3 color) {
  if (!IsFinite(from) || !IsFinite(to) || !IsFinite(color)) return;
  lines_.push_back({from, to, Opaque(color)});
}

void DebugDraw::Triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 color) {
  if (!IsFinite(a) || !IsFinite(b) || !IsFinite(c) || !IsFinite(color)) return;
  triangles_.push_back({a, b, c, {color.x, color.y, color.z, kFillAlpha}});
}

void DebugDraw::Circle(Vec3 center, float radius_m, Vec3 color) {
  // The sum is finite if and only if all values are finite.
  const float sum = std::abs(center.x) + std::abs(center.y) + std::abs(center.z) + radius_m + std::abs(color.x) +
                    std::abs(color.y) + std::abs(color.z);
  if (!(radius_m > 0) || !(sum <= std::numeric_limits<float>::max())) return;
  circles_.push_back({center, radius_m, Opaque(color)});
}

void AppendLines(const std::vector<CircleSnapshot>& circles, std::vector<LineSnapshot>& lines) {
  static const std::vector<Vec3> kUnitCircle = MakeUnitCircle();
  lines.reserve(lines.size() + kLinesOfCircle * circles.size());
  for (const CircleSnapshot& circle : circles) {
    Vec3 last = circle.center + Vec3{circle.radius_m, 0, 0};
    for (const Vec3 corner : kUnitCircle) {
      const Vec3 next = circle.center + corner * circle.radius_m;
      lines.push_back({last, next, circle.color});
      last = next;
    }
  }
}

void DebugDraw::Sphere(Vec3 center, float radius_m, Vec3 color, bool filled) {
  if (!(radius_m > 0)) return;
  static const UnitSphere kSphere = MakeUnitSphere();
  for (const auto& [from, to] : kSphere.edges) Line(center + from * radius_m, center + to * radius_m, color);
  if (!filled) return;
  for (const auto& face : kSphere.faces) {
    Triangle(center + face[0] * radius_m, center + face[1] * radius_m, center + face[2] * radius_m, color);
  }
}

void DebugDraw::Square(Vec3 center, float side_m, Vec3 color, bool filled) {
  const float half = side_m / 2;
  const std::array<Vec3, 4> corners{center + Vec3{-half, 0, -half}, center + Vec3{-half, 0, half},
                                    center + Vec3{half, 0, half}, center + Vec3{half, 0, -half}};
  for (std::size_t i = 0; i < 4; ++i) Line(corners[i], corners[(i + 1) % 4], color);
  if (!filled) return;
  Triangle(corners[0], corners[1], corners[2], color);
  Triangle(corners[2], corners[3], corners[0], color);
}

void DebugDraw::Clear() {
  lines_.clear();
  circles_.clear();
  triangles_.clear();
}

}  // namespace soarbox::world
