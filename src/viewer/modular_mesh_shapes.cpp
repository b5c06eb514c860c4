// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/modular_mesh_shapes.h"

#include <algorithm>

#include "viewer/shape_meshes.h"
#include "world/modular_meshes.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

bool Has(std::string_view name, std::string_view part) {
  return name.find(part) != std::string_view::npos;
}

MeshData Box(Vec3 min, Vec3 max) {
  return BoxMesh(min, max, {.chamfer_m = 0.02f, .metric_uv = true});
}

void PaintPart(MeshData& mesh, float tint, float light, float gloss) {
  for (MeshVertex& vertex : mesh.vertices) {
    vertex.tint = tint;
    vertex.light = light;
    vertex.gloss = gloss;
  }
}

/// An opening in a wall, as fractions of its width and height.
struct Opening {
  float left, right, bottom, top;
};

/// A wall with openings next to each other, from left to right, with sills, lintels and posts around them and optional
/// glass in them.
MeshData WallWith(Vec3 min, Vec3 max, const std::vector<Opening>& openings, bool glass) {
  const Vec3 size = max - min;
  const auto at = [&](float x, float y, float z) {
    return Vec3{min.x + x * size.x, min.y + y * size.y, min.z + z * size.z};
  };
  MeshData mesh;
  float left = 0;
  for (const Opening& hole : openings) {
    mesh.Append(Box(at(left, 0, 0), at(hole.left, 1, 1)));
    mesh.Append(Box(at(hole.left, hole.top, 0), at(hole.right, 1, 1)));
    if (hole.bottom > 0) mesh.Append(Box(at(hole.left, 0, 0), at(hole.right, hole.bottom, 1)));
    if (glass) {
      MeshData pane = Box(at(hole.left, hole.bottom, 0.42f), at(hole.right, hole.top, 0.58f));
      PaintPart(pane, 0, 1.0f, 1.0f);
      mesh.Append(pane);
    }
    left = hole.right;
  }
  mesh.Append(Box(at(left, 0, 0), at(1, 1, 1)));
  return mesh;
}

/// A slab with raised bands: roofs, doors of hangars, coolers.
MeshData Ribbed(Vec3 min, Vec3 max, int ribs) {
  const Vec3 size = max - min;
  MeshData mesh = Box({min.x, min.y, min.z}, {max.x, max.y, max.z - 0.25f * size.z});
  for (int i = 0; i < ribs; ++i) {
    const float low = min.y + size.y * (static_cast<float>(i) + 0.1f) / static_cast<float>(ribs);
    const float high = min.y + size.y * (static_cast<float>(i) + 0.9f) / static_cast<float>(ribs);
    mesh.Append(Box({min.x, low, max.z - 0.3f * size.z}, {max.x, high, max.z}));
  }
  return mesh;
}

/// A shaft between a wider base and head.
MeshData Pillar(Vec3 min, Vec3 max) {
  const Vec3 size = max - min;
  const float inset = 0.08f * size.x, cap = std::min(0.16f, 0.12f * size.y);
  MeshData mesh = Box({min.x + inset, min.y, min.z + inset}, {max.x - inset, max.y, max.z - inset});
  mesh.Append(Box(min, {max.x, min.y + cap, max.z}));
  mesh.Append(Box({min.x, max.y - cap, min.z}, max));
  return mesh;
}

/// A crate: a box set back slightly behind a frame along its edges.
MeshData Crate(Vec3 min, Vec3 max) {
  const Vec3 size = max - min;
  const float beam = 0.13f * std::min({size.x, size.y, size.z}), depth = 0.045f * size.x;
  const Vec3 set_back{depth, depth, depth};
  MeshData mesh = Box(min + set_back, max - set_back);
  for (MeshVertex& vertex : mesh.vertices) vertex.light = 0.82f;
  for (const bool high_a : {false, true}) {
    for (const bool high_b : {false, true}) {
      const auto span = [&](bool high, float lo, float hi) {
        return high ? std::pair{hi - beam, hi} : std::pair{lo, lo + beam};
      };
      const auto [x0, x1] = span(high_a, min.x, max.x);
      const auto [z0, z1] = span(high_b, min.z, max.z);
      const auto [ya0, ya1] = span(high_a, min.y, max.y);
      const auto [yb0, yb1] = span(high_b, min.y, max.y);
      mesh.Append(Box({x0, min.y, z0}, {x1, max.y, z1}));
      mesh.Append(Box({min.x + beam, ya0, z0}, {max.x - beam, ya1, z1}));
      mesh.Append(Box({x0, yb0, min.z + beam}, {x1, yb1, max.z - beam}));
    }
  }
  return mesh;
}

MeshData Build(const world::ModularMesh& piece) {
  const std::string_view name = piece.name;
  const Vec3 min = piece.min, max = piece.max;
  if (Has(name, "block")) return Crate(min, max);
  if (Has(name, "pillar")) return Pillar(min, max);
  if (Has(name, "cooling")) return Ribbed(min, max, 6);
  if (Has(name, "hangar")) return Ribbed(min, max, 8);
  if (Has(name, "small_double_window"))
    return WallWith(min, max, {{0.14f, 0.44f, 0.5f, 0.8f}, {0.56f, 0.86f, 0.5f, 0.8f}}, true);
  if (Has(name, "double_window"))
    return WallWith(min, max, {{0.1f, 0.45f, 0.3f, 0.82f}, {0.55f, 0.9f, 0.3f, 0.82f}}, true);
  if (Has(name, "small_window")) return WallWith(min, max, {{0.3f, 0.7f, 0.5f, 0.8f}}, true);
  if (Has(name, "window")) return WallWith(min, max, {{0.22f, 0.78f, 0.3f, 0.82f}}, true);
  if (world::HasDoorway(name)) {
    const world::Doorway hole;
    return WallWith(min, max, {{hole.left, hole.right, 0.0f, hole.top}}, false);
  }
  return Box(min, max);
}

}  // namespace

std::optional<MeshData> ModularMesh(std::string_view resource_name) {
  constexpr std::string_view kFolder = "models/nobiax_modular/", kSuffix = ".mesh";
  if (!resource_name.starts_with(kFolder) || !resource_name.ends_with(kSuffix)) return std::nullopt;
  resource_name.remove_prefix(kFolder.size());
  resource_name.remove_suffix(kSuffix.size());
  const auto& pieces = world::kModularMeshes;
  const auto found =
      std::find_if(pieces.begin(), pieces.end(), [&](const world::ModularMesh& p) { return p.name == resource_name; });
  if (found == pieces.end()) return std::nullopt;
  MeshData mesh = Build(*found);
  const bool metal = Has(found->name, "cooling") || Has(found->name, "hangar");
  mesh.material = Has(found->name, "brick")   ? "Soarbox/Brick"
                  : Has(found->name, "block") ? "Soarbox/Crate"
                  : metal                     ? "Soarbox/Metal"
                                              : "Soarbox/Concrete";
  return mesh;
}

}  // namespace soarbox::viewer
