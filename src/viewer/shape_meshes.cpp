// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/shape_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viewer/half_turn.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

constexpr int kSegments = 28;
thread_local bool is_coarse = false;

float Sane(float size) {
  return std::isfinite(size) && size > 0 ? size : 0.0f;
}

/// One ring of a body of revolution.
struct ShapeRing {
  float radius, y;
  float tint = 1, light = 1, gloss = 0;
};

/// Rotates a profile, given from bottom to top, around the y axis. Normals follow the profile's slope.
MeshData Revolve(const std::vector<ShapeRing>& profile, int fine_segments = kSegments) {
  MeshData mesh;
  const int segments = PiecesOf(fine_segments);
  const std::size_t count = profile.size();
  for (std::size_t i = 0; i < count; ++i) {
    const ShapeRing& below = profile[i > 0 ? i - 1 : i];
    const ShapeRing& above = profile[i + 1 < count ? i + 1 : i];
    const float dr = above.radius - below.radius, dy = above.y - below.y;
    const float length = std::max(std::sqrt(dr * dr + dy * dy), 1e-6f);
    float out = dy / length, up = -dr / length;
    if (profile[i].radius < 1e-5f) {
      out = 0;
      up = i == 0 ? -1.0f : 1.0f;
    }
    for (int s = 0; s <= segments; ++s) {
      const float turn = static_cast<float>(s) / static_cast<float>(segments);
      const float x = std::sin(2 * kPi * turn), z = std::cos(2 * kPi * turn);
      MeshVertex vertex;
      vertex.position = {profile[i].radius * x, profile[i].y, profile[i].radius * z};
      vertex.normal = {out * x, up, out * z};
      vertex.u = turn;
      vertex.v = 1 - static_cast<float>(i) / static_cast<float>(count - 1);
      vertex.tint = profile[i].tint;
      vertex.light = profile[i].light;
      vertex.gloss = profile[i].gloss;
      mesh.vertices.push_back(vertex);
    }
  }
  const auto row = static_cast<std::uint32_t>(segments) + 1;
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    for (std::uint32_t s = 0; s + 1 < row; ++s) {
      const std::uint32_t a = i * row + s;
      mesh.AddQuad(a, a + 1, a + row + 1, a + row);
    }
  }
  return mesh;
}

/// Adds the rings of an arc of an ellipse; angles from the horizontal, both ends included.
void AddArc(std::vector<ShapeRing>& profile, float radius, float height, float centre_y, float from, float to,
            int fine_steps) {
  const int steps = is_coarse ? std::max(2, (2 * fine_steps + 2) / 5) : fine_steps;
  for (int i = 0; i <= steps; ++i) {
    const float angle = from + (to - from) * static_cast<float>(i) / static_cast<float>(steps);
    profile.push_back({std::max(0.0f, radius * std::cos(angle)), centre_y + height * std::sin(angle)});
  }
}

/// Radius of a profile at a height, interpolated between its rings.
float RadiusAt(const std::vector<ShapeRing>& profile, float y) {
  for (std::size_t i = 1; i < profile.size(); ++i) {
    if (y > profile[i].y) continue;
    const float span = std::max(profile[i].y - profile[i - 1].y, 1e-6f);
    const float t = std::clamp((y - profile[i - 1].y) / span, 0.0f, 1.0f);
    return profile[i - 1].radius + (profile[i].radius - profile[i - 1].radius) * t;
  }
  return 0;
}

/// A raised patch on the front (+z) of the profile with the outline of a superellipse; its border is inside the body.
MeshData Visor(const std::vector<ShapeRing>& profile, float low_y, float high_y, float half_angle, float radius,
               int fine_columns, int fine_rows) {
  const int columns = PiecesOf(fine_columns), rows = PiecesOf(fine_rows);
  const auto point = [&](float a, float b) {
    const float y = (low_y + high_y) / 2 + (high_y - low_y) / 2 * b;
    const float inside = 1 - std::pow(std::abs(a), 4.0f) - std::pow(std::abs(b), 4.0f);
    const float r =
        RadiusAt(profile, y) + radius * (inside > 0 ? 0.075f * std::sqrt(inside) : -0.10f * std::min(1.0f, -inside));
    return Vec3{r * std::sin(a * half_angle), y, r * std::cos(a * half_angle)};
  };
  MeshData mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const float a = 2.0f * static_cast<float>(column) / static_cast<float>(columns) - 1,
                  b = 2.0f * static_cast<float>(row) / static_cast<float>(rows) - 1;
      MeshVertex vertex;
      vertex.position = point(a, b);
      const Vec3 across = point(a + 0.02f, b) - point(a - 0.02f, b), up = point(a, b + 0.02f) - point(a, b - 0.02f);
      vertex.normal = world::Normalized(Cross(across, up));
      vertex.tint = 0;
      vertex.gloss = 1;
      mesh.vertices.push_back(vertex);
    }
  }
  const auto width = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < width; ++column) {
      const std::uint32_t a = row * width + column;
      mesh.AddQuad(a, a + 1, a + width + 1, a + width);
    }
  }
  return mesh;
}

}  // namespace

CoarseShapes::CoarseShapes() : before_(std::exchange(is_coarse, true)) {}
CoarseShapes::~CoarseShapes() {
  is_coarse = before_;
}
int PiecesOf(int fine) {
  return is_coarse ? std::max(5, static_cast<int>(std::lround(0.45 * fine))) : fine;
}

MeshData BoxMesh(Vec3 min, Vec3 max, const BoxStyle& style) {
  const Vec3 size{Sane(max.x - min.x), Sane(max.y - min.y), Sane(max.z - min.z)};
  const float chamfer = std::min(style.chamfer_m, 0.2f * std::min({size.x, size.y, size.z}));
  const std::array<float, 3> lo{min.x, min.y, min.z};
  const std::array<float, 3> hi{min.x + size.x, min.y + size.y, min.z + size.z};

  // Face (axis, side) has four corners, at indices 4 * face + (2 * high_v + high_u), where u and v are the next axes.
  MeshData mesh;
  const auto index = [](int axis, bool high, bool high_u, bool high_v) {
    return static_cast<std::uint32_t>(4 * (2 * axis + (high ? 1 : 0)) + (high_v ? 2 : 0) + (high_u ? 1 : 0));
  };
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t n = axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      for (const bool high_v : {false, true}) {
        for (const bool high_u : {false, true}) {
          std::array<float, 3> p{}, normal{};
          p[n] = high ? hi[n] : lo[n];
          p[u] = high_u ? hi[u] - chamfer : lo[u] + chamfer;
          p[v] = high_v ? hi[v] - chamfer : lo[v] + chamfer;
          normal[n] = high ? 1.0f : -1.0f;
          MeshVertex vertex;
          vertex.position = {p[0], p[1], p[2]};
          vertex.normal = {normal[0], normal[1], normal[2]};
          // The texture's v follows the world's y on upright faces.
          const std::size_t across = n == 0 ? 2 : 0, upward = n == 1 ? 2 : 1;
          if (style.metric_uv) {
            vertex.u = p[across];
            vertex.v = -p[upward];
          } else {
            vertex.u = style.repeats_u * (p[across] - lo[across]) / std::max(hi[across] - lo[across], 1e-6f);
            vertex.v = style.repeats_v * (1 - (p[upward] - lo[upward]) / std::max(hi[upward] - lo[upward], 1e-6f));
          }
          mesh.vertices.push_back(vertex);
        }
      }
      const auto a = index(axis, high, false, false), b = index(axis, high, true, false);
      const auto c = index(axis, high, true, true), d = index(axis, high, false, true);
      if (high)
        mesh.AddQuad(a, b, c, d);
      else
        mesh.AddQuad(a, d, c, b);
    }
  }
  if (chamfer <= 0) return mesh;

  // Twelve chamfers: between the faces of axis n and axis u, along axis v.
  for (int n = 0; n < 3; ++n) {
    const int u = (n + 1) % 3;
    for (const bool high_n : {false, true}) {
      for (const bool high_u : {false, true}) {
        // For face n, u is the first coordinate and v the second; for face u, v is the first and n the second.
        const auto a = index(n, high_n, high_u, false), b = index(n, high_n, high_u, true);
        const auto c = index(u, high_u, true, high_n), d = index(u, high_u, false, high_n);
        if (high_n == high_u)
          mesh.AddQuad(a, d, c, b);
        else
          mesh.AddQuad(a, b, c, d);
      }
    }
  }
  // Eight corners.
  for (const bool x : {false, true}) {
    for (const bool y : {false, true}) {
      for (const bool z : {false, true}) {
        const auto a = index(0, x, y, z), b = index(1, y, z, x), c = index(2, z, x, y);
        if (x ^ y ^ z)
          mesh.AddTriangle(a, b, c);
        else
          mesh.AddTriangle(a, c, b);
      }
    }
  }
  return mesh;
}

MeshData CapsuleMesh(float radius_m, float height_m) {
  const float radius = Sane(radius_m), half = std::max(0.0f, Sane(height_m) / 2 - radius);
  std::vector<ShapeRing> profile;
  AddArc(profile, radius, radius, -half, -kPi / 2, 0, 8);
  AddArc(profile, radius, radius, half, 0, kPi / 2, 8);
  return Revolve(profile);
}

MeshData AgentMesh(float radius_m, float height_m, AgentDetail detail) {
  const float r = Sane(radius_m), height = std::max(Sane(height_m), 2 * r), bottom = -height / 2, top = height / 2;
  const float neck = top - 0.36f * height;  // Where the head begins.

  struct Pieces {
    int arc, foot, around, visor_across, visor_up;
  };
  constexpr Pieces kPieces[] = {{10, 6, kSegments, 24, 14}, {5, 3, 14, 10, 6}, {3, 2, 8, 4, 3}, {2, 1, 8, 4, 3}};
  const Pieces& pieces = kPieces[static_cast<std::size_t>(detail)];
  const bool coarse = detail >= AgentDetail::kCoarse;

  // Foot: a dark, rounded base. Torso: a slight taper. Groove: the neck. Head: a dome that fills the capsule's cap.
  std::vector<ShapeRing> profile;
  AddArc(profile, 0.86f * r, 0.42f * r, bottom + 0.42f * r, -kPi / 2, 0, pieces.foot);
  for (ShapeRing& ring : profile) ring.light = 0.75f;
  if (detail != AgentDetail::kTiny) profile.push_back({0.90f * r, bottom + 0.55f * r});
  profile.push_back({0.95f * r, bottom + 0.85f * r});
  if (!coarse) {
    profile.push_back({0.985f * r, (bottom + 0.85f * r + neck) / 2});
    profile.push_back({0.99f * r, neck - 0.14f * r});
    profile.push_back({0.965f * r, neck - 0.06f * r});
    profile.push_back({0.915f * r, neck - 0.015f * r, 1, 0.7f});
    profile.push_back({0.885f * r, neck + 0.005f * r, 0, 0.6f});
    profile.push_back({0.885f * r, neck + 0.055f * r, 0, 0.6f});
    profile.push_back({0.915f * r, neck + 0.075f * r, 1, 0.7f});
    profile.push_back({0.965f * r, neck + 0.12f * r});
  }
  const float dome = std::max(top - r, neck + 0.20f * r);
  AddArc(profile, r, top - dome, dome, 0, kPi / 2, pieces.arc);

  MeshData mesh = Revolve(profile, pieces.around);
  const float low = neck + 0.26f * r, high = std::max(low + 0.3f * r, dome + 0.50f * (top - dome));
  mesh.Append(Visor(profile, low, high, 1.05f, r, pieces.visor_across, pieces.visor_up));
  return mesh;
}

MeshData CylinderMesh(float radius_m, float height_m) {
  const float radius = Sane(radius_m), half = Sane(height_m) / 2;
  const float rim = std::min({0.03f, 0.2f * radius, 0.4f * half});
  std::vector<ShapeRing> profile{{0, -half}, {0.5f * (radius - rim), -half}};
  AddArc(profile, rim, rim, -half + rim, -kPi / 2, 0, 3);
  for (std::size_t i = 2; i < profile.size(); ++i) profile[i].radius += radius - rim;
  const std::size_t lower = profile.size();
  AddArc(profile, rim, rim, half - rim, 0, kPi / 2, 3);
  for (std::size_t i = lower; i < profile.size(); ++i) profile[i].radius += radius - rim;
  profile.push_back({0.5f * (radius - rim), half});
  profile.push_back({0, half});
  return Revolve(profile);
}

MeshData SphereMesh(float radius_m) {
  std::vector<ShapeRing> profile;
  AddArc(profile, Sane(radius_m), Sane(radius_m), 0, -kPi / 2, kPi / 2, 18);
  return Revolve(profile);
}

MeshData PlaneMesh(float size_x_m, float size_z_m, float repeats_u, float repeats_v) {
  const float x = Sane(size_x_m) / 2, z = Sane(size_z_m) / 2;
  MeshData mesh;
  const Vec3 up{0, 1, 0};
  mesh.vertices = {{{-x, 0, -z}, up, 0, 0},
                   {{-x, 0, z}, up, 0, repeats_v},
                   {{x, 0, z}, up, repeats_u, repeats_v},
                   {{x, 0, -z}, up, repeats_u, 0}};
  mesh.AddQuad(0, 1, 2, 3);
  return mesh;
}

}  // namespace soarbox::viewer
