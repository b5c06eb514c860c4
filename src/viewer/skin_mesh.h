// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "viewer/mesh_data.h"
#include "world/animation/bone_pose.h"
#include "world/animation/skeleton.h"

namespace soarbox::viewer {

/// The bones that move a vertex: at most two; `share` is the weight of the first.
struct SkinVertex {
  std::uint8_t bone = 0, other = 0;
  float share = 1;
};

/// Triangles that bones move, in the bind pose.
struct SkinMesh {
  MeshData mesh;
  std::vector<SkinVertex> skin;  ///< One per vertex.
};

/// The material of a piece: a cell of the texture of cloths (cloth_image.h), or the colour of the team.
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

/// Builds bodies from rounded pieces: lofts through rings, and superquadrics (boxes and ellipsoids).
class SkinBuilder {
 public:
  /// `fineness`: 1 is fine; 0.5 and less for distant bodies.
  explicit SkinBuilder(float fineness) : fineness_(fineness) {}

  SkinVertex bone;  ///< The bone of the pieces that follow, unless they set their own.
  Cloth cloth = Cloth::kCamouflage;
  float light = 1;
  world::BonePose place;  ///< The place of the pieces that follow.

  /// A ring of a loft: its centre and its radii in the directions `right` and `ahead`. `square`: 0 is an ellipse, 1
  /// nearly a rectangle.
  struct Ring {
    world::Vec3 centre;
    float right = 0.1f, ahead = 0.1f;
    SkinVertex skin;
    float square = 0;
    float light = 1;
  };
  /// Joins rings by a surface. The plane of each ring is perpendicular to the line between its neighbours. `ahead` is
  /// the direction in which Ring::ahead is measured, and must not be parallel to that line. With `closed_ends`, both
  /// ends are closed.
  void Loft(const std::vector<Ring>& rings, int segments, world::Vec3 ahead, bool closed_ends = true);

  /// A superquadric around `centre` with half sizes `half`. `round`: 1 is an ellipsoid, 0.2 a box with round edges.
  /// `from` and `to`: the part that is built, from -1 (bottom) to 1 (top).
  void Round(world::Vec3 centre, world::Vec3 half, float round, int segments = 14, float from = -1, float to = 1);
  /// The same, with each point moved by `bend`.
  void Round(world::Vec3 centre, world::Vec3 half, float round, int segments, float from, float to,
             const std::function<world::Vec3(world::Vec3)>& bend);
  /// A tube of constant radius through points.
  void Tube(const std::vector<world::Vec3>& points, float radius, int segments = 8);

  SkinMesh Take() { return std::move(made_); }

 private:
  /// Adds closed rows of points as a grid with smooth normals.
  void AddGrid(const std::vector<std::vector<world::Vec3>>& rows, const std::vector<SkinVertex>& skins,
               const std::vector<float>& lights);
  void AddVertex(world::Vec3 at, world::Vec3 normal, const SkinVertex& skin, float light_here);
  int Count(int segments) const;

  float fineness_;
  SkinMesh made_;
};

/// The place and the size of a body.
struct SkinPlace {
  world::BonePose at;
  world::Vec3 scale{1, 1, 1};
  friend bool operator==(const SkinPlace&, const SkinPlace&) = default;
};

/// For each bone of a skeleton, the transform of a point from the model in the bind pose to the bone's own space.
std::vector<world::BonePose> ToBind(const world::Skeleton& skeleton);

/// For each bone, three rows of four numbers: the matrix that transforms a vertex from the bind pose to world space.
/// `out` has twelve numbers for each of `bones`. Bones beyond those of the skeleton are ignored.
void BoneRows(const std::vector<world::BonePose>& to_bind, const std::vector<world::BonePose>& bones,
              const SkinPlace& place, float* out);

}  // namespace soarbox::viewer
