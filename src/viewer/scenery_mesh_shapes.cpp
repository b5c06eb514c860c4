// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/scenery_mesh_shapes.h"

#include <algorithm>
#include <cmath>

#include "viewer/half_turn.h"
#include "viewer/noise.h"
#include "world/scenery_meshes.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

/// A random number of the seed, 0..1.
float Chance(std::uint32_t seed, int index) {
  return LatticeValue(index, 17, 3, seed * 7919u);
}

/// Joins rows of rings to a surface with smooth normals; each row is closed.
void AddRings(MeshData& mesh, const std::vector<std::vector<Vec3>>& rows, float tint, float light_below,
              float light_above, float uv_per_m) {
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::size_t around = rows[0].size();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t s = 0; s <= around; ++s) {
      const std::size_t here = s % around;
      const std::size_t up = std::min(r + 1, rows.size() - 1), down = r > 0 ? r - 1 : 0;
      std::size_t wide = r;
      if (world::LengthSquared(rows[r][0] - rows[r][around / 2]) < 1e-6f) wide = r == 0 ? 1 : r - 1;
      const Vec3 across = rows[wide][(here + 1) % around] - rows[wide][(here + around - 1) % around];
      MeshVertex vertex;
      vertex.position = rows[r][here];
      vertex.normal = world::Normalized(Cross(across, rows[up][here] - rows[down][here]));
      vertex.u = static_cast<float>(s) / static_cast<float>(around) * uv_per_m * 3;
      vertex.v = -vertex.position.y * uv_per_m;
      vertex.tint = tint;
      vertex.light =
          light_below + (light_above - light_below) * static_cast<float>(r) / static_cast<float>(rows.size() - 1);
      mesh.vertices.push_back(vertex);
    }
  }
  const auto row = static_cast<std::uint32_t>(around) + 1;
  for (std::uint32_t r = 0; r + 1 < rows.size(); ++r) {
    for (std::uint32_t s = 0; s + 1 < row; ++s) {
      const std::uint32_t a = base + r * row + s;
      mesh.AddQuad(a, a + 1, a + row + 1, a + row);
    }
  }
}

std::vector<Vec3> Circle(Vec3 centre, float radius, int count, std::uint32_t seed, float rough) {
  std::vector<Vec3> ring;
  for (int i = 0; i < count; ++i) {
    const float angle = 2 * kPi * static_cast<float>(i) / static_cast<float>(count);
    const float r = radius * (1 + rough * (Chance(seed, i) - 0.5f));
    ring.push_back(centre + Vec3{r * std::sin(angle), 0, r * std::cos(angle)});
  }
  return ring;
}

void AddTrunk(MeshData& mesh, float height, float radius, std::uint32_t seed) {
  std::vector<std::vector<Vec3>> rows;
  for (int i = 0; i <= 6; ++i) {
    const float t = static_cast<float>(i) / 6;
    const float foot = 1 + 0.7f * std::pow(1 - t, 8.0f);
    const Vec3 bend{0.05f * height * (Noise2(t * 2, 0.5f, seed) - 0.5f) * t, 0,
                    0.05f * height * (Noise2(0.5f, t * 2, seed + 1) - 0.5f) * t};
    rows.push_back(Circle(bend + Vec3{0, t * height, 0}, radius * foot * (1 - 0.6f * t), 9, seed + 5, 0.25f));
  }
  AddRings(mesh, rows, 0, 0.7f, 1.0f, 0.8f);
}

/// Cones of twigs, one above the other, each with a ragged lower edge.
MeshData Pine(float size, std::uint32_t seed) {
  MeshData mesh;
  mesh.material = "Soarbox/Leaves";
  AddTrunk(mesh, 0.85f * size, 0.024f * size, seed);
  constexpr int kSkirts = 9, kPoints = 22;
  for (int skirt = 0; skirt < kSkirts; ++skirt) {
    const float t = static_cast<float>(skirt) / kSkirts;
    const float low = size * (0.14f + 0.76f * t), high = low + size * (0.26f - 0.10f * t);
    const float wide = size * (0.245f - 0.205f * std::pow(t, 0.85f)) * (0.92f + 0.16f * Chance(seed, skirt));
    const Vec3 lean{0.02f * size * (Chance(seed, 40 + skirt) - 0.5f), 0,
                    0.02f * size * (Chance(seed, 60 + skirt) - 0.5f)};
    std::vector<std::vector<Vec3>> rows(4);
    for (int i = 0; i < kPoints; ++i) {
      const float angle = 2 * kPi * (static_cast<float>(i) + 0.4f * Chance(seed, 100 + skirt)) / kPoints;
      const bool twig = i % 2 == 0;
      const float reach = wide * (twig ? 1.0f : 0.74f) * (0.86f + 0.28f * Chance(seed, skirt * 37 + i));
      const float hang = size * (twig ? 0.030f : 0.008f);
      const Vec3 out{std::sin(angle), 0, std::cos(angle)};
      rows[0].push_back(lean + Vec3{0, low + 0.03f * size, 0} + out * (0.25f * reach));
      rows[1].push_back(lean + Vec3{0, low - hang, 0} + out * reach);
      rows[2].push_back(lean + Vec3{0, low + 0.42f * (high - low), 0} + out * (0.52f * reach));
      rows[3].push_back(lean + Vec3{0, high, 0});
    }
    AddRings(mesh, rows, 1, 0.42f, 1.0f, 1.1f);
  }
  return mesh;
}

/// A ball of leaves: a sphere with lumps.
void AddCrown(MeshData& mesh, Vec3 centre, Vec3 half, std::uint32_t seed, int around) {
  std::vector<std::vector<Vec3>> rows;
  const int up = around / 2;
  for (int r = 0; r <= up; ++r) {
    const float t = kPi * (static_cast<float>(r) / static_cast<float>(up) - 0.5f);
    std::vector<Vec3> row;
    for (int s = 0; s < around; ++s) {
      const float angle = 2 * kPi * static_cast<float>(s) / static_cast<float>(around);
      const Vec3 out{std::cos(t) * std::sin(angle), std::sin(t), std::cos(t) * std::cos(angle)};
      const bool pole = r == 0 || r == up;
      const float lump = pole ? 1.0f
                              : 1 + 0.42f * (LatticeValue(s, r, 1, seed) - 0.5f) +
                                    0.25f * (Noise2(out.x * 2 + 5, out.y * 2 + out.z * 2 + 5, seed) - 0.5f);
      row.push_back(centre + Vec3{half.x * out.x, half.y * out.y, half.z * out.z} * lump);
    }
    rows.push_back(std::move(row));
  }
  AddRings(mesh, rows, 1, 0.45f, 1.05f, 0.95f);
}

MeshData Oak(float size, std::uint32_t seed) {
  MeshData mesh;
  mesh.material = "Soarbox/Leaves";
  AddTrunk(mesh, 0.62f * size, 0.040f * size, seed);
  // Branches, each with its crown, around a central crown.
  AddCrown(mesh, {0, 0.72f * size, 0}, {0.25f * size, 0.20f * size, 0.25f * size}, seed + 1, 18);
  for (int i = 0; i < 7; ++i) {
    const float angle = 2 * kPi * (static_cast<float>(i) + 0.6f * Chance(seed, i)) / 7;
    const float out = size * (0.17f + 0.09f * Chance(seed, 10 + i)),
                high = size * (0.50f + 0.28f * Chance(seed, 20 + i));
    const float half = size * (0.13f + 0.06f * Chance(seed, 30 + i));
    AddCrown(mesh, {out * std::sin(angle), high, out * std::cos(angle)}, {half, 0.82f * half, half},
             seed + 40 + static_cast<std::uint32_t>(i), 14);
  }
  return mesh;
}

/// A ball cut by planes, so that it has faces and edges, with added roughness.
MeshData Rock(const world::SceneryMesh& piece) {
  MeshData mesh;
  mesh.material = "Soarbox/Stone";
  const Vec3 size = piece.bounds.max - piece.bounds.min;
  struct Cut {
    Vec3 normal;
    float at;
  };
  std::vector<Cut> cuts;
  for (int i = 0; i < 16; ++i) {
    const Vec3 n = world::Normalized(Vec3{Chance(piece.seed, i) - 0.5f, 0.9f * (Chance(piece.seed, 30 + i) - 0.4f),
                                          Chance(piece.seed, 60 + i) - 0.5f});
    cuts.push_back({n, 0.66f + 0.26f * Chance(piece.seed, 90 + i)});
  }
  constexpr int kAround = 30, kUp = 18;
  struct Corner {
    Vec3 position, normal;
  };
  std::vector<std::vector<Corner>> rows;
  for (int r = 0; r <= kUp; ++r) {
    const float t = kPi * (static_cast<float>(r) / kUp - 0.5f);
    std::vector<Corner> row;
    for (int s = 0; s < kAround; ++s) {
      const float angle = 2 * kPi * static_cast<float>(s) / kAround;
      const Vec3 out{std::cos(t) * std::sin(angle), std::sin(t), std::cos(t) * std::cos(angle)};
      float reach = 1;
      Vec3 normal = out;
      for (const Cut& cut : cuts) {
        const float facing = Dot(out, cut.normal);
        if (facing <= 0.05f || cut.at / facing >= reach) continue;
        reach = cut.at / facing;
        normal = cut.normal;
      }
      const float rough = Fractal2(out.x * 3 + 9, out.y * 3 + out.z * 2 + 9, 3, piece.seed) - 0.5f;
      const Vec3 p = out * (reach * (1 + 0.05f * rough));
      // The normal is that of the cutting plane, with added roughness. The mesh is scaled, so its normals are scaled
      // inversely.
      normal = normal + Vec3{rough, 0.4f * rough, -rough} * 0.5f;
      normal = {normal.x / size.x, normal.y / (1.16f * size.y), normal.z / size.z};
      row.push_back(
          {{0.5f * size.x * p.x, std::max(-0.02f * size.y, size.y * (0.42f + 0.58f * p.y)), 0.5f * size.z * p.z},
           world::Normalized(normal)});
    }
    rows.push_back(std::move(row));
  }
  // Each triangle has its own corners, because the stone texture is projected from one side.
  const auto add = [&mesh](const Corner& a, const Corner& b, const Corner& c) {
    const Vec3 face = Cross(b.position - a.position, c.position - a.position);
    if (world::LengthSquared(face) < 1e-12f) return;
    const Vec3 side = world::Normalized(a.normal + b.normal + c.normal);
    for (const Corner& corner : {a, b, c}) {
      const Vec3 p = corner.position;
      MeshVertex vertex;
      vertex.position = p;
      vertex.normal = corner.normal;
      vertex.u = std::abs(side.x) > 0.7f ? p.z : p.x;
      vertex.v = std::abs(side.y) > 0.7f ? p.z : -p.y;
      vertex.light = std::clamp(0.62f + 0.9f * p.y, 0.62f, 1.0f);
      mesh.vertices.push_back(vertex);
    }
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.AddTriangle(count - 3, count - 2, count - 1);
  };
  for (std::size_t r = 0; r + 1 < rows.size(); ++r) {
    for (std::size_t s = 0; s < rows[r].size(); ++s) {
      const std::size_t next = (s + 1) % rows[r].size();
      add(rows[r][s], rows[r][next], rows[r + 1][next]);
      add(rows[r][s], rows[r + 1][next], rows[r + 1][s]);
    }
  }
  return mesh;
}

}  // namespace

std::optional<MeshData> SceneryMeshFor(std::string_view resource_name) {
  for (const world::SceneryMesh& piece : world::kSceneryMeshes) {
    if (piece.name != resource_name) continue;
    switch (piece.kind) {
      case world::SceneryKind::kPine:
        return Pine(piece.size_m, piece.seed);
      case world::SceneryKind::kOak:
        return Oak(piece.size_m, piece.seed);
      case world::SceneryKind::kRock:
        return Rock(piece);
    }
  }
  return std::nullopt;
}

}  // namespace soarbox::viewer
