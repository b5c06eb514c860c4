// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "world/math.h"

namespace soarbox::world {

/// The bounding box of a mesh in m, in its own coordinates. The origin is the centre of mass of objects made from it.
struct MeshBounds {
  Vec3 min{-0.5f, -0.5f, -0.5f};
  Vec3 max{0.5f, 0.5f, 0.5f};
};

/// The names of meshes, materials, skies and particle templates that scripts may use, and the size of each mesh.
///
/// A new catalog contains the names of the sandbox's scripts; files of a world add meshes. Looking up an unknown name
/// queues one warning per name, with a suggestion, and returns a replacement: a box of 1 m for meshes, "White" for
/// materials, nothing for skies and particle templates.
class MediaCatalog {
 public:
  MediaCatalog();

  void AddMesh(std::string name, MeshBounds bounds);
  bool HasMesh(std::string_view name) const { return meshes_.contains(name); }

  MeshBounds LookUpMesh(std::string_view name);
  std::string LookUpMaterial(std::string_view name);
  std::string LookUpSky(std::string_view name);
  std::string LookUpParticle(std::string_view name);
  /// Core.CacheResource: returns whether a resource of any kind has this name, and warns if none has.
  bool CheckResource(std::string_view name);

  /// Queues a warning. Each message is queued only once.
  void Warn(std::string message, std::string hint);
  /// The warnings since the last call, oldest first.
  std::vector<Diagnostic> TakeWarnings();
  bool HasWarnings() const { return !warnings_.empty(); }

 private:
  /// Warns of an unknown name, and suggests one of a mesh.
  void WarnOfMesh(std::string_view what, std::string_view name, std::string_view otherwise);

  std::map<std::string, MeshBounds, std::less<>> meshes_;
  std::set<std::string> warned_;
  std::vector<Diagnostic> warnings_;
};

}  // namespace soarbox::world
