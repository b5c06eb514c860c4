// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/backdrop_meshes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "viewer/half_turn.h"
#include "viewer/noise.h"
#include "viewer/shape_meshes.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

constexpr float kHalf_m = kPlainSide_m / 2;

/// Distance from the centre of the square plain to its edge in a direction.
float EdgeAt(float angle) {
  return kHalf_m / std::max(std::abs(std::sin(angle)), std::abs(std::cos(angle)));
}

/// Height of the hills at a distance outside the edge of the plain.
float HillAt(float angle, float behind_m) {
  // The noise follows the angle, so there is no seam.
  const float x = 2.4f * std::sin(angle) + 7, z = 2.4f * std::cos(angle) + 7;
  const float crest = 3 + 17 * Fractal2(x, z, 3, 21);
  const float rise = std::clamp(behind_m / 55, 0.0f, 1.0f);
  return -0.4f + crest * rise * rise * (3 - 2 * rise);
}

Vec3 OnHills(float angle, float behind_m) {
  const float away = EdgeAt(angle) + behind_m;
  return {away * std::sin(angle), HillAt(angle, behind_m), away * std::cos(angle)};
}

/// A cone of a few sides with its tip up.
void AddCone(MeshData& mesh, Vec3 foot, float radius, float height, float tint, float light) {
  constexpr int kSides = 7;
  for (int i = 0; i < kSides; ++i) {
    const float one = 2 * kPi * static_cast<float>(i) / kSides, next = 2 * kPi * static_cast<float>(i + 1) / kSides;
    const auto rim = [&](float angle) { return foot + Vec3{radius * std::sin(angle), 0, radius * std::cos(angle)}; };
    const Vec3 a = rim(one), b = rim(next), tip = foot + Vec3{0, height, 0};
    const Vec3 normal = world::Normalized(Cross(b - a, tip - a));
    for (const Vec3 p : {a, b, tip}) {
      MeshVertex vertex;
      vertex.position = p;
      vertex.normal = normal;
      vertex.u = p.x * 0.6f + p.z * 0.4f;
      vertex.v = -p.y * 0.6f;
      vertex.tint = tint;
      vertex.light = light * (p == tip ? 1.0f : 0.62f);
      mesh.vertices.push_back(vertex);
    }
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.AddTriangle(count - 3, count - 2, count - 1);
  }
}

}  // namespace

MeshData HillsMesh() {
  MeshData mesh;
  mesh.material = "Soarbox/Hills";
  constexpr int kAround = 160;
  constexpr float kBehind_m[] = {-6, 2, 10, 20, 32, 45, 60, 80};
  constexpr int kRows = static_cast<int>(std::size(kBehind_m));
  for (int r = 0; r < kRows; ++r) {
    for (int s = 0; s <= kAround; ++s) {
      const float angle = 2 * kPi * static_cast<float>(s % kAround) / kAround, behind = kBehind_m[r];
      MeshVertex vertex;
      vertex.position = OnHills(angle, behind);
      const Vec3 across = OnHills(angle + 0.02f, behind) - OnHills(angle - 0.02f, behind);
      const Vec3 outwards = OnHills(angle, behind + 2) - OnHills(angle, behind - 2);
      vertex.normal = world::Normalized(Cross(outwards, across));
      if (vertex.normal.y < 0) vertex.normal = vertex.normal * -1.0f;
      const float patch = Fractal2(vertex.position.x * 0.06f + 50, vertex.position.z * 0.06f + 50, 3, 4);
      vertex.light = 0.72f + 0.5f * patch;
      vertex.tint = patch > 0.30f ? 1.0f : 0.75f;
      mesh.vertices.push_back(vertex);
    }
  }
  constexpr auto kRow = static_cast<std::uint32_t>(kAround + 1);
  for (std::uint32_t r = 0; r + 1 < static_cast<std::uint32_t>(kRows); ++r) {
    for (std::uint32_t s = 0; s < static_cast<std::uint32_t>(kAround); ++s) {
      const std::uint32_t a = r * kRow + s;
      mesh.AddQuad(a, a + kRow, a + kRow + 1, a + 1);
    }
  }
  return mesh;
}

MeshData TreesMesh() {
  MeshData mesh;
  mesh.material = "Soarbox/Leaves";
  constexpr int kTrees = 150;
  for (int i = 0; i < kTrees; ++i) {
    const auto chance = [&](int n) { return LatticeValue(i, n, 9, 31); };
    // Woods with gaps between them.
    const float angle = 2 * kPi * (static_cast<float>(i) + chance(1)) / kTrees;
    const float wood = Noise2(3 * std::sin(angle) + 5, 3 * std::cos(angle) + 5, 8);
    if (wood < 0.42f && chance(2) < 0.8f) continue;
    const Vec3 foot = OnHills(angle, 3 + 42 * chance(3));
    const float high = 4.5f + 4.5f * chance(4), light = 0.85f + 0.3f * chance(5);
    AddCone(mesh, foot + Vec3{0, -0.3f, 0}, 0.05f * high, 0.4f * high, 0, 0.9f);
    for (const float level : {0.16f, 0.40f, 0.63f})
      AddCone(mesh, foot + Vec3{0, level * high, 0}, (0.30f - 0.28f * level) * high, 0.42f * high, 1, light);
  }
  return mesh;
}

MeshData FenceMesh() {
  MeshData mesh;
  mesh.material = "Soarbox/Sack";
  constexpr float kAt_m = 97, kPost_m = 1.2f;
  constexpr int kPosts = 32;
  for (int side = 0; side < 4; ++side) {
    const auto place = [&](float along, float y) -> Vec3 {
      switch (side) {
        case 0:
          return {along, y, -kAt_m};
        case 1:
          return {along, y, kAt_m};
        case 2:
          return {-kAt_m, y, along};
        default:
          return {kAt_m, y, along};
      }
    };
    const auto add = [&](Vec3 middle, Vec3 size) {
      MeshData box = BoxMesh(middle - size * 0.5f, middle + size * 0.5f, {.chamfer_m = 0});
      for (MeshVertex& vertex : box.vertices) vertex.tint = 0.45f;
      mesh.Append(box);
    };
    for (int i = 0; i <= kPosts; ++i) {
      const float along = kAt_m * (2 * static_cast<float>(i) / kPosts - 1);
      add(place(along, kPost_m / 2), {0.14f, kPost_m, 0.14f});
    }
    for (const float y : {0.5f, 0.95f})
      add(place(0, y), side < 2 ? Vec3{2 * kAt_m, 0.10f, 0.06f} : Vec3{0.06f, 0.10f, 2 * kAt_m});
  }
  return mesh;
}

}  // namespace soarbox::viewer
