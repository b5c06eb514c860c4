// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "world/navigation_mesh.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {

struct OverlaySnapshot;

/// The navigation meshes of one world, by name. Create starts to build a mesh on another thread. Find waits until it is
/// ready, so a run does not depend on how long that takes. Owned by the World; used only on its thread.
class Navigation {
 public:
  static constexpr std::size_t kMaxMeshes = 32;

  Navigation();
  ~Navigation();

  /// Starts to build a mesh; replaces a mesh of the same name. Fails at once if the configuration or the geometry is
  /// invalid. If nothing is walkable, the first Find fails. Returns whether parts of the geometry are ignored because
  /// they are too far from the origin.
  Result<bool> Create(std::string_view name, NavigationGeometry geometry, const NavigationConfig& config);
  /// Waits for the mesh if it is being built. Fails if there is no such mesh, or if it could not be built.
  Result<const NavigationMesh*> Find(std::string_view name);
  std::vector<std::string_view> Names() const;

  /// Shows or hides the mesh in snapshots. Waits for the mesh and fails as Find does.
  Result<void> Show(std::string_view name, bool show);
  void FillSnapshot(SceneSnapshot& snapshot) const;
  /// Draws all meshes for which Find or a later Create has waited, shown or hidden.
  void FillOverlay(OverlaySnapshot& overlays) const;
  /// Hash of the sources of all meshes. Does not wait.
  std::uint64_t Hash() const;

 private:
  using Outcome = Result<std::unique_ptr<NavigationMesh>>;
  struct Entry {
    std::future<Outcome> building;
    std::unique_ptr<NavigationMesh> mesh;
    Diagnostic fault;  ///< Why there is no mesh; empty while it is being built.
    std::uint64_t source_hash = 0;
    bool shown = false;
  };
  static void Finish(Entry& entry);

  std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace soarbox::world
