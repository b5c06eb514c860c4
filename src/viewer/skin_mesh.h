// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "viewer/mesh_data.h"
#include "world/animation/bone_pose.h"
#include "world/animation/skeleton.h"

namespace soarbox::viewer {

/// Which bones move a vertex: two at most, the first by `share`.
struct SkinVertex {
  std::uint8_t bone = 0, other = 0;
  float share = 1;
};

/// Triangles that bones move, in the bind pose.
struct SkinMesh {
  MeshData mesh;
  std::vector<SkinVertex> skin;  ///< One per vertex.
};

/// What a piece is made of: a cell of the picture of cloths (cloth_image.h), or the colour of the team.
enum class Cloth : std::uint8_t {
  kCamouflage,
  kWebbing,
  kSkin,
  kLeather,
  kMetal,
  kGlass,
  kHelmet,
  kRubber,
  kSteel,
  kTeam,
  kDarkCamouflage,
  kDarkWebbing,
  kDarkHelmet
};

/// Builds bodies from rounded pieces: lofts through rings, and boxes and balls in one (superquadrics).
class SkinBuilder {
 public:
  /// fineness: 1 fine, 0.5 and less for what is seen from afar.
  explicit SkinBuilder(float fineness) : fineness_(fineness) {}

  SkinVertex bone;  ///< What moves the pieces that follow, where they do not say it themselves.
  Cloth cloth = Cloth::kCamouflage;
  float light = 1;
  world::BonePose place;  ///< The pieces that follow are put here.

  /// A ring of a loft: around `centre`, `right` and `ahead` wide; square 0: an ellipse, 1: nearly a rectangle.
  struct Ring {
    world::Vec3 centre;
    float right = 0.1f, ahead = 0.1f;
    SkinVertex skin;
    float square = 0;
    float light = 1;
  };
  /// Joins rings whose planes stand across `along`, with `ahead` as their second direction. Ends are closed.
  void Loft(const std::vector<Ring>& rings, int segments, world::Vec3 ahead, bool closed_ends = true);

  /// A body around `centre` with half sizes `half`; round 1: an ellipsoid, 0.2: a box with round edges.
  void Round(world::Vec3 centre, world::Vec3 half, float round, int segments = 14, float from = -1, float to = 1);
  /// The same, with the points moved by a function of their place.
  void Round(world::Vec3 centre, world::Vec3 half, float round, int segments, float from, float to,
             const std::function<world::Vec3(world::Vec3)>& bend);
  /// A tube of one thickness through points.
  void Tube(const std::vector<world::Vec3>& points, float radius, int segments = 8);

  SkinMesh Take() { return std::move(made_); }

 private:
  /// Rows of points that close around; adds them as a grid with smooth normals.
  void AddGrid(const std::vector<std::vector<world::Vec3>>& rows, const std::vector<SkinVertex>& skins,
               const std::vector<float>& lights);
  void AddVertex(world::Vec3 at, world::Vec3 normal, const SkinVertex& skin, float light_here);
  int Count(int segments) const;

  float fineness_;
  SkinMesh made_;
};

/// Where a body stands, and how large it is.
struct SkinPlace {
  world::BonePose at;
  world::Vec3 scale{1, 1, 1};
  friend bool operator==(const SkinPlace&, const SkinPlace&) = default;
};

/// For each bone of a skeleton, what takes a point of the model in the bind pose into the bone's own space.
std::vector<world::BonePose> ToBind(const world::Skeleton& skeleton);

/// For each bone, three rows of four numbers: the matrix that takes a vertex from the bind pose to where the bone has
/// it in the world. `out` holds twelve for each of `bones`; those beyond the skeleton's do not count.
void BoneRows(const std::vector<world::BonePose>& to_bind, const std::vector<world::BonePose>& bones,
              const SkinPlace& place, float* out);

}  // namespace soarbox::viewer
