// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/figure_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viewer/half_turn.h"
#include "viewer/noise.h"
#include "viewer/shape_meshes.h"
#include "world/rotation.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

/// How a part is painted: 1 is the material's colour, 0 its second one.
struct Coat {
  float tint = 1, light = 1, gloss = 0;
};

void Paste(MeshData& mesh, MeshData part, Vec3 at, Coat coat) {
  for (MeshVertex& vertex : part.vertices) {
    vertex.position += at;
    vertex.tint = coat.tint;
    vertex.light *= coat.light;
    vertex.gloss = coat.gloss;
  }
  mesh.Append(part);
}

/// An ellipsoid with these half axes, with lumps of this relative size.
MeshData Ball(Vec3 half, float lumps = 0, std::uint32_t seed = 1) {
  const int around = PiecesOf(16), up = PiecesOf(10);
  MeshData mesh;
  for (int r = 0; r <= up; ++r) {
    const float t = kPi * (static_cast<float>(r) / static_cast<float>(up) - 0.5f);
    for (int s = 0; s <= around; ++s) {
      const float angle = 2 * kPi * static_cast<float>(s % around) / static_cast<float>(around);
      const Vec3 out{std::cos(t) * std::sin(angle), std::sin(t), std::cos(t) * std::cos(angle)};
      const float lump = 1 + lumps * (Noise2(4 * out.x + 9, 4 * out.y + 4 * out.z + 9, seed) - 0.5f);
      MeshVertex vertex;
      vertex.position = Vec3{half.x * out.x, half.y * out.y, half.z * out.z} * lump;
      vertex.normal = world::Normalized(Vec3{out.x / half.x, out.y / half.y, out.z / half.z});
      vertex.light = 0.78f + 0.22f * (0.5f + 0.5f * out.y) + 0.5f * lumps * (lump - 1);
      mesh.vertices.push_back(vertex);
    }
  }
  const auto row = static_cast<std::uint32_t>(around + 1);
  for (std::uint32_t r = 0; r < static_cast<std::uint32_t>(up); ++r) {
    for (std::uint32_t s = 0; s + 1 < row; ++s) {
      const std::uint32_t a = r * row + s;
      mesh.AddQuad(a, a + 1, a + row + 1, a + row);
    }
  }
  return mesh;
}

MeshData BoxAt(Vec3 middle, Vec3 size, float chamfer_m = 0.02f) {
  return BoxMesh(middle - size * 0.5f, middle + size * 0.5f, {.chamfer_m = chamfer_m});
}

/// Fits a mesh that stands on the ground at the origin to a shape of this size, whose centre is at the origin. The mesh
/// keeps its proportions: a shape of height kUsual_m gets it in its original size.
MeshData Standing(MeshData mesh, Vec3 size) {
  constexpr float kUsual_m = 1.7f;
  const float scale = size.y / kUsual_m;
  for (MeshVertex& vertex : mesh.vertices) vertex.position = vertex.position * scale + Vec3{0, -size.y / 2, 0};
  return mesh;
}

struct Beast {
  float length, height, leg, girth;  ///< Of the trunk in m; `height` is that of the back.
  Vec3 head;                         ///< Half axes.
  float head_up, head_ahead;         ///< From the front of the back.
  float ear, tail;
  float lumps;
  bool dark_head, dark_legs;
};

MeshData Animal(const Beast& b) {
  MeshData mesh;
  const float belly = b.leg, body_y = belly + b.girth;
  Paste(mesh, Ball({b.girth, b.girth, b.length / 2}, b.lumps, 7), {0, body_y, 0}, {});
  const Coat legs{b.dark_legs ? 0.0f : 1.0f, 0.85f, 0}, head{b.dark_head ? 0.0f : 1.0f, 1, 0.05f};
  for (const float x : {-0.55f, 0.55f}) {
    for (const float z : {-0.32f, 0.32f}) {
      Paste(mesh, CylinderMesh(0.20f * b.girth, belly + 0.5f * b.girth),
            {x * b.girth, (belly + 0.5f * b.girth) / 2, z * b.length}, legs);
    }
  }
  const Vec3 at{0, b.height + b.head_up, b.length / 2 + b.head_ahead};
  // A neck from the trunk to the head.
  Paste(mesh, Ball({0.55f * b.girth, 0.8f * b.girth, 0.55f * b.girth}, b.lumps, 5),
        {0, (at.y + body_y) / 2, (at.z + 0.32f * b.length) / 2}, {});
  Paste(mesh, Ball(b.head), at, head);
  // A muzzle and eyes, which show the direction of its face.
  Paste(mesh, Ball({0.6f * b.head.x, 0.5f * b.head.y, 0.55f * b.head.z}),
        at + Vec3{0, -0.25f * b.head.y, 0.75f * b.head.z}, {0, 0.9f, 0.1f});
  for (const float side : {-1.0f, 1.0f}) {
    Paste(mesh, Ball({0.35f * b.head.x, b.ear, 0.2f * b.head.x}),
          at + Vec3{side * 0.8f * b.head.x, 0.7f * b.head.y + 0.6f * b.ear, -0.2f * b.head.z}, head);
    Paste(mesh, Ball({0.14f * b.head.x, 0.16f * b.head.y, 0.10f * b.head.z}),
          at + Vec3{side * 0.55f * b.head.x, 0.25f * b.head.y, 0.72f * b.head.z}, {0, 0.25f, 0.6f});
  }
  Paste(mesh, Ball({b.tail, b.tail, b.tail}), {0, body_y + 0.3f * b.girth, -b.length / 2}, {1, 1.15f, 0});
  return mesh;
}

MeshData Sheep() {
  return Animal({1.05f, 0.95f, 0.30f, 0.33f, {0.11f, 0.13f, 0.19f}, 0.10f, 0.02f, 0.07f, 0.09f, 0.35f, true, true});
}

MeshData Bear() {
  return Animal({1.75f, 1.25f, 0.42f, 0.46f, {0.24f, 0.23f, 0.28f}, 0.12f, 0.10f, 0.09f, 0.08f, 0.12f, false, false});
}

MeshData Hare() {
  return Animal({0.48f, 0.36f, 0.12f, 0.13f, {0.075f, 0.085f, 0.10f}, 0.09f, 0.0f, 0.14f, 0.055f, 0.1f, false, false});
}

MeshData Wolf() {
  return Animal({1.30f, 0.82f, 0.40f, 0.22f, {0.12f, 0.13f, 0.22f}, 0.12f, 0.08f, 0.11f, 0.10f, 0.15f, false, false});
}

/// A person in a tunic with a sun hat.
MeshData Villager() {
  MeshData mesh;
  for (const float x : {-0.10f, 0.10f}) Paste(mesh, CylinderMesh(0.085f, 0.80f), {x, 0.40f, 0}, {0, 0.35f, 0});
  Paste(mesh, Ball({0.23f, 0.42f, 0.16f}), {0, 1.00f, 0}, {});
  for (const float x : {-0.26f, 0.26f}) {
    Paste(mesh, CapsuleMesh(0.065f, 0.52f), {x, 1.08f, 0.04f}, {1, 0.85f, 0});
    Paste(mesh, Ball({0.065f, 0.065f, 0.065f}), {x, 0.80f, 0.05f}, {0, 1, 0.05f});
  }
  Paste(mesh, Ball({0.105f, 0.135f, 0.12f}), {0, 1.47f, 0}, {0, 1, 0.05f});
  for (const float x : {-0.04f, 0.04f})
    Paste(mesh, Ball({0.015f, 0.018f, 0.012f}), {x, 1.49f, 0.115f}, {0, 0.1f, 0.6f});
  Paste(mesh, CylinderMesh(0.22f, 0.02f), {0, 1.56f, 0}, {0, 1.15f, 0});
  Paste(mesh, Ball({0.13f, 0.11f, 0.13f}), {0, 1.59f, 0}, {0, 1.15f, 0});
  return mesh;
}

/// A low machine on wheels, with a lamp that shows its direction.
MeshData Robot() {
  MeshData mesh = BoxAt({0, 0.34f, -0.05f}, {0.72f, 0.34f, 1.05f}, 0.08f);
  Paste(mesh, BoxAt({0, 0.56f, -0.12f}, {0.50f, 0.14f, 0.62f}, 0.06f), {}, {1, 0.75f, 0.2f});
  for (const float x : {-0.42f, 0.42f}) {
    Paste(mesh, Ball({0.07f, 0.26f, 0.26f}), {x, 0.26f, -0.30f}, {0, 0.8f, 0.1f});
    Paste(mesh, Ball({0.06f, 0.16f, 0.16f}), {x, 0.16f, 0.36f}, {0, 0.8f, 0.1f});
  }
  Paste(mesh, CylinderMesh(0.02f, 0.35f), {0, 0.78f, -0.30f}, {0, 1, 0.3f});
  Paste(mesh, Ball({0.06f, 0.06f, 0.06f}), {0, 0.97f, -0.30f}, {1, 1.3f, 0.6f});
  Paste(mesh, BoxAt({0, 0.40f, 0.50f}, {0.40f, 0.10f, 0.06f}), {}, {0, 2.5f, 0.6f});
  return mesh;
}

/// A loaded wooden cart with its shafts at the front.
MeshData Cart() {
  MeshData mesh = BoxAt({0, 0.52f, -0.15f}, {0.80f, 0.08f, 1.40f});
  for (const float x : {-0.40f, 0.40f}) {
    Paste(mesh, BoxAt({x, 0.72f, -0.15f}, {0.05f, 0.34f, 1.40f}), {}, {1, 0.85f, 0});
    Paste(mesh, Ball({0.06f, 0.36f, 0.36f}), {1.2f * x, 0.36f, -0.15f}, {0, 0.7f, 0});
    Paste(mesh, BoxAt({0.7f * x, 0.52f, 0.95f}, {0.06f, 0.06f, 0.90f}), {}, {1, 0.8f, 0});
  }
  for (const float z : {-0.85f, 0.55f}) Paste(mesh, BoxAt({0, 0.72f, z}, {0.80f, 0.34f, 0.05f}), {}, {1, 0.85f, 0});
  Paste(mesh, Ball({0.36f, 0.30f, 0.62f}, 0.35f, 4), {0, 0.80f, -0.15f}, {0, 1.9f, 0});
  return mesh;
}

/// A bee as large as a dog, a metre above the ground.
MeshData Bee() {
  constexpr float kUp = 1.15f;
  MeshData mesh;
  Paste(mesh, Ball({0.24f, 0.23f, 0.36f}), {0, kUp, -0.12f}, {});
  for (const float z : {-0.32f, -0.14f, 0.04f}) {
    const float wide = std::sqrt(1 - (z + 0.12f) * (z + 0.12f) / (0.36f * 0.36f));
    Paste(mesh, Ball({0.255f * wide, 0.245f * wide, 0.055f}), {0, kUp, z}, {0, 0.9f, 0});
  }
  Paste(mesh, Ball({0.16f, 0.16f, 0.15f}), {0, kUp + 0.04f, 0.32f}, {0, 1.4f, 0.05f});
  for (const float side : {-1.0f, 1.0f}) {
    Paste(mesh, Ball({0.05f, 0.07f, 0.04f}), {side * 0.09f, kUp + 0.10f, 0.43f}, {0, 5, 0.5f});
    Paste(mesh, Ball({0.34f, 0.015f, 0.16f}), {side * 0.40f, kUp + 0.24f, -0.02f}, {0, 11, 0.2f});
    Paste(mesh, CapsuleMesh(0.012f, 0.18f), {side * 0.05f, kUp + 0.26f, 0.38f}, {0, 1, 0});
  }
  return mesh;
}

/// A bell that hangs between two posts.
MeshData Bell() {
  MeshData mesh;
  for (const float x : {-0.62f, 0.62f}) Paste(mesh, BoxAt({x, 0.85f, 0}, {0.14f, 1.70f, 0.14f}), {}, {0, 1, 0});
  Paste(mesh, BoxAt({0, 1.70f, 0}, {1.50f, 0.14f, 0.18f}), {}, {0, 0.85f, 0});
  Paste(mesh, CylinderMesh(0.05f, 0.20f), {0, 1.55f, 0}, {1, 0.7f, 0.3f});
  Paste(mesh, Ball({0.30f, 0.42f, 0.30f}), {0, 1.12f, 0}, {1, 1, 0.45f});
  Paste(mesh, CylinderMesh(0.37f, 0.12f), {0, 0.86f, 0}, {1, 0.9f, 0.45f});
  Paste(mesh, Ball({0.09f, 0.09f, 0.09f}), {0, 0.76f, 0}, {1, 0.6f, 0.3f});
  return mesh;
}

/// A pile of metal bars, larger than the thing itself so that it is visible from far away.
MeshData Bars(Vec3 size) {
  MeshData mesh;
  const float unit = size.x, ground = -0.5f * size.y;
  for (int row = 0; row < 3; ++row) {
    const int bars = 3 - row;
    for (int i = 0; i < bars; ++i) {
      const float x = (static_cast<float>(i) - 0.5f * static_cast<float>(bars - 1)) * 0.95f * unit;
      const float y = ground + (0.25f + 0.5f * static_cast<float>(row)) * unit;
      Paste(mesh, BoxAt({x, y, 0}, {0.86f * unit, 0.48f * unit, 1.9f * unit}, 0.12f * unit), {},
            {1, 0.85f + 0.08f * static_cast<float>((i + row) % 3), 0.6f});
    }
  }
  return mesh;
}

/// A flower of knee height with six petals.
MeshData Flower(Vec3 size) {
  MeshData mesh;
  const float unit = size.x, ground = -0.5f * size.y, top = ground + 1.7f * unit;
  Paste(mesh, CylinderMesh(0.10f * unit, 1.7f * unit), {0, 0.5f * (ground + top), 0}, {0, 0.6f, 0});
  for (const float side : {-1.0f, 1.0f})
    Paste(mesh, Ball({0.50f * unit, 0.06f * unit, 0.20f * unit}), {side * 0.5f * unit, ground + 0.5f * unit, 0},
          {0, 0.7f, 0});
  for (int i = 0; i < 6; ++i) {
    const float angle = kPi * static_cast<float>(i) / 3;
    Paste(mesh, Ball({0.48f * unit, 0.12f * unit, 0.48f * unit}),
          {0.72f * unit * std::cos(angle), top, 0.72f * unit * std::sin(angle)}, {});
  }
  Paste(mesh, Ball({0.42f * unit, 0.22f * unit, 0.42f * unit}), {0, top + 0.06f * unit, 0}, {0, 1.5f, 0});
  return mesh;
}

/// Leaves that fill the box.
MeshData Hedge(Vec3 size) {
  MeshData mesh = BoxAt({}, size * 0.94f, 0.1f * std::min({size.x, size.y, size.z}));
  for (MeshVertex& vertex : mesh.vertices) vertex.light *= 0.72f;
  const bool is_coarse = PiecesOf(16) < 16;
  const float ball = std::clamp(1.3f * std::min({size.x, size.y, size.z}), 0.25f, 1.2f) * (is_coarse ? 1.9f : 1.0f);
  const auto steps = [&](float side) { return std::clamp(static_cast<int>(std::lround(1.6f * side / ball)), 1, 24); };
  const int across = steps(size.x), up = steps(size.y), along = steps(size.z);
  std::uint32_t seed = 3;
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < up; ++j) {
      for (int k = 0; k < along; ++k, ++seed) {
        const bool is_inside = i > 0 && i + 1 < across && j > 0 && j + 1 < up && k > 0 && k + 1 < along;
        if (is_inside) continue;
        const auto at = [](int n, int count, float side) {
          return side * ((static_cast<float>(n) + 0.5f) / static_cast<float>(count) - 0.5f);
        };
        const float light = 0.80f + 0.35f * LatticeValue(i, j, k, 11);
        const float half = 0.5f * ball;
        Paste(mesh, Ball({half, half, half}, 0.5f, seed),
              {at(i, across, size.x), at(j, up, size.y), at(k, along, size.z)}, {1, light, 0});
      }
    }
  }
  return mesh;
}

/// A person in white with an apron and a tall hat.
MeshData Cook() {
  MeshData mesh;
  for (const float x : {-0.10f, 0.10f}) Paste(mesh, CylinderMesh(0.085f, 0.80f), {x, 0.40f, 0}, {0, 0.45f, 0});
  Paste(mesh, Ball({0.24f, 0.40f, 0.17f}), {0, 1.02f, 0}, {});
  Paste(mesh, BoxAt({0, 0.86f, 0.12f}, {0.34f, 0.52f, 0.08f}), {}, {1, 0.86f, 0});
  for (const float x : {-0.27f, 0.27f}) {
    Paste(mesh, CapsuleMesh(0.065f, 0.52f), {x, 1.08f, 0.04f}, {1, 0.95f, 0});
    Paste(mesh, Ball({0.065f, 0.065f, 0.065f}), {x, 0.80f, 0.05f}, {0, 1, 0.05f});
  }
  Paste(mesh, Ball({0.105f, 0.135f, 0.12f}), {0, 1.47f, 0}, {0, 1, 0.05f});
  for (const float x : {-0.04f, 0.04f})
    Paste(mesh, Ball({0.015f, 0.018f, 0.012f}), {x, 1.49f, 0.115f}, {0, 0.1f, 0.6f});
  Paste(mesh, CylinderMesh(0.115f, 0.14f), {0, 1.62f, 0}, {1, 1.05f, 0});
  Paste(mesh, Ball({0.17f, 0.11f, 0.17f}, 0.25f, 3), {0, 1.74f, 0}, {1, 1.1f, 0});
  return mesh;
}

/// A case with a cross on each side and a handle.
MeshData Medkit(Vec3 size) {
  MeshData mesh = BoxAt({}, size, 0.12f * std::min({size.x, size.y, size.z}));
  for (MeshVertex& vertex : mesh.vertices) vertex.gloss = 0.15f;
  const float arm = 0.62f, bar = 0.22f, thick = 0.02f;
  const auto cross = [&](Vec3 middle, Vec3 across, Vec3 along, Vec3 out, float wide, float high) {
    const float reach = std::min(wide, high);
    for (const auto& [a, b] : {std::pair{arm, bar}, std::pair{bar, arm}}) {
      const Vec3 part = across * (a * reach) + along * (b * reach) + out * (thick * reach);
      Paste(mesh, BoxAt(middle, {std::abs(part.x), std::abs(part.y), std::abs(part.z)}, 0.004f), {}, {0, 1, 0.1f});
    }
  };
  for (const float side : {-0.5f, 0.5f}) {
    cross({0, 0, side * size.z}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, size.x, size.y);
    cross({side * size.x, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, size.z, size.y);
  }
  cross({0, 0.5f * size.y, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, size.x, size.z);
  return mesh;
}

/// A flat case with bands and rounds standing in it.
MeshData Ammunition(Vec3 size) {
  MeshData mesh = BoxAt({0, -0.12f * size.y, 0}, {size.x, 0.76f * size.y, size.z}, 0.05f * size.y);
  for (const float x : {-0.3f, 0.3f}) {
    Paste(mesh, BoxAt({x * size.x, -0.12f * size.y, 0}, {0.08f * size.x, 0.79f * size.y, 1.03f * size.z}, 0.004f), {},
          {1, 0.6f, 0});
  }
  for (int i = 0; i < 5; ++i) {
    const float x = (static_cast<float>(i) / 4 - 0.5f) * 0.7f * size.x;
    for (const float z : {-0.22f, 0.22f})
      Paste(mesh, CapsuleMesh(0.055f * size.x, 0.55f * size.y), {x, 0.26f * size.y, z * size.z}, {0, 1, 0.5f});
  }
  return mesh;
}

/// A sack, tied at the top.
MeshData Sack(Vec3 size) {
  MeshData mesh;
  Paste(mesh, Ball({0.48f * size.x, 0.40f * size.y, 0.48f * size.z}, 0.22f, 11), {0, -0.10f * size.y, 0}, {});
  Paste(mesh, CylinderMesh(0.11f * size.x, 0.20f * size.y), {0, 0.34f * size.y, 0}, {0, 1, 0});
  Paste(mesh, Ball({0.20f * size.x, 0.09f * size.y, 0.20f * size.z}, 0.4f, 4), {0, 0.44f * size.y, 0}, {});
  return mesh;
}

/// A boulder that fills the box: a rough sphere with faces.
MeshData RoundRock(Vec3 size) {
  constexpr int kAround = 22, kUp = 13;
  const auto seed = static_cast<std::uint32_t>(std::abs(size.x * 37 + size.y * 91 + size.z * 53));
  std::array<std::pair<Vec3, float>, 14> cuts;
  for (int i = 0; i < static_cast<int>(cuts.size()); ++i) {
    const auto chance = [&](int n) { return LatticeValue(i, n, 5, seed); };
    cuts[static_cast<std::size_t>(i)] = {
        world::Normalized(Vec3{chance(1) - 0.5f, 0.8f * (chance(2) - 0.35f), chance(3) - 0.5f}),
        0.72f + 0.22f * chance(4)};
  }
  std::array<std::array<Vec3, kAround>, kUp + 1> rows;
  for (int r = 0; r <= kUp; ++r) {
    const float t = kPi * (static_cast<float>(r) / kUp - 0.5f);
    for (int s = 0; s < kAround; ++s) {
      const float angle = 2 * kPi * static_cast<float>(s) / kAround;
      const Vec3 out{std::cos(t) * std::sin(angle), std::sin(t), std::cos(t) * std::cos(angle)};
      float reach = 1;
      for (const auto& [normal, at] : cuts) {
        const float facing = Dot(out, normal);
        if (facing > 0.05f) reach = std::min(reach, at / facing);
      }
      // Nearly a cube, so that the body behind it does not protrude.
      const float square = 1 / std::max({std::abs(out.x), std::abs(out.y), std::abs(out.z)});
      const float rough = 0.06f * (Noise2(5 * out.x + 9, 5 * out.y + 5 * out.z + 9, seed) - 0.5f);
      const Vec3 p = out * (reach * (1 + rough) * (0.55f + 0.45f * square));
      rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(s)] = {0.5f * size.x * std::clamp(p.x, -1.0f, 1.0f),
                                                                        0.5f * size.y * std::clamp(p.y, -1.0f, 1.0f),
                                                                        0.5f * size.z * std::clamp(p.z, -1.0f, 1.0f)};
    }
  }
  MeshData mesh;
  const auto add = [&](Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 face = Cross(b - a, c - a);
    if (world::LengthSquared(face) < 1e-12f) return;
    const Vec3 normal = world::Normalized(face);
    for (const Vec3 p : {a, b, c}) {
      MeshVertex vertex;
      vertex.position = p;
      vertex.normal = normal;
      vertex.u = std::abs(normal.x) > 0.7f ? p.z : p.x;
      vertex.v = std::abs(normal.y) > 0.7f ? p.z : -p.y;
      vertex.light = 0.70f + 0.30f * std::clamp(p.y / std::max(0.1f, size.y) + 0.5f, 0.0f, 1.0f);
      mesh.vertices.push_back(vertex);
    }
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.AddTriangle(count - 3, count - 2, count - 1);
  };
  for (std::size_t r = 0; r < kUp; ++r) {
    for (std::size_t s = 0; s < kAround; ++s) {
      const std::size_t next = (s + 1) % kAround;
      add(rows[r][s], rows[r][next], rows[r + 1][next]);
      add(rows[r][s], rows[r + 1][next], rows[r + 1][s]);
    }
  }
  return mesh;
}

struct Figure {
  std::string_view material;
  MeshData (*make)(Vec3 size);
};

constexpr Figure kFigures[] = {
    {"Soarbox/Rock", RoundRock},
    {"Soarbox/Medkit", Medkit},
    {"Soarbox/Ammunition", Ammunition},
    {"Soarbox/Sack", Sack},
    {"Soarbox/Sheep", [](Vec3 size) { return Standing(Sheep(), size); }},
    {"Soarbox/Bear", [](Vec3 size) { return Standing(Bear(), size); }},
    {"Soarbox/Hare", [](Vec3 size) { return Standing(Hare(), size); }},
    {"Soarbox/Cook", [](Vec3 size) { return Standing(Cook(), size); }},
    {"Soarbox/Wolf", [](Vec3 size) { return Standing(Wolf(), size); }},
    {"Soarbox/Villager", [](Vec3 size) { return Standing(Villager(), size); }},
    {"Soarbox/Robot", [](Vec3 size) { return Standing(Robot(), size); }},
    {"Soarbox/Cart", [](Vec3 size) { return Standing(Cart(), size); }},
    {"Soarbox/Bee", [](Vec3 size) { return Standing(Bee(), size); }},
    {"Soarbox/Bell", [](Vec3 size) { return Standing(Bell(), size); }},
    {"Soarbox/Gold", Bars},
    {"Soarbox/Silver", Bars},
    {"Soarbox/Bronze", Bars},
    {"Soarbox/RedFlower", Flower},
    {"Soarbox/BlueFlower", Flower},
    {"Soarbox/WhiteFlower", Flower},
    {"Soarbox/Hedge", Hedge},
};

}  // namespace

bool IsFigure(std::string_view material) {
  return std::any_of(std::begin(kFigures), std::end(kFigures),
                     [&](const Figure& figure) { return figure.material == material; });
}

std::optional<MeshData> FigureMesh(std::string_view material, Vec3 size) {
  if (!world::IsFinite(size) || size.x <= 0 || size.y <= 0 || size.z <= 0) return std::nullopt;
  for (const Figure& figure : kFigures) {
    if (figure.material != material) continue;
    MeshData mesh = figure.make(size);
    mesh.material = std::string(material);
    return mesh;
  }
  return std::nullopt;
}

}  // namespace soarbox::viewer
