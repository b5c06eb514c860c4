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

/// The box around a mesh, in m, in the mesh's own space; its origin is the centre of mass of objects made of it.
struct MeshBounds {
  Vec3 min{-0.5f, -0.5f, -0.5f};
  Vec3 max{0.5f, 0.5f, 0.5f};
};

/// The names that scripts may use for meshes, materials, skies and particle templates, and the size of each mesh.
///
/// A new catalog knows what the sandbox's scripts name; an application adds what it ships beyond that. A look-up of an
/// unknown name queues one warning per name, with a suggestion, and answers with a stand-in: a box of 1 m for meshes,
/// "White" for materials, nothing for skies and particle templates.
class MediaCatalog {
 public:
  MediaCatalog();

  void AddMesh(std::string name, MeshBounds bounds);
  void AddMaterial(std::string name);
  void AddSky(std::string name);
  void AddParticle(std::string name);

  bool HasMesh(std::string_view name) const;
  bool HasMaterial(std::string_view name) const;

  MeshBounds LookUpMesh(std::string_view name);
  std::string LookUpMaterial(std::string_view name);
  std::string LookUpSky(std::string_view name);
  std::string LookUpParticle(std::string_view name);
  /// Core.CacheResource: warns if no resource of any kind has this name; true if one has.
  bool CheckResource(std::string_view name);

  /// Queues a warning unless one with the same message was queued before.
  void Warn(std::string message, std::string hint);
  /// The warnings since the last call, oldest first.
  std::vector<Diagnostic> TakeWarnings();
  bool HasWarnings() const { return !warnings_.empty(); }

 private:
  std::map<std::string, MeshBounds, std::less<>> meshes_;
  std::set<std::string, std::less<>> materials_, skies_, particles_;
  std::set<std::string> warned_;
  std::vector<Diagnostic> warnings_;
};

}  // namespace soarbox::world
