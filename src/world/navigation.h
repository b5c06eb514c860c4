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

/// The navigation meshes of one world, by name. A mesh is built on a thread of its own as soon as it is asked for.
/// Whoever asks it something waits until it is ready, so a run does not depend on how long that takes. Owned by the
/// World; for the world's thread only.
class Navigation {
 public:
  static constexpr std::size_t kMaxMeshes = 32;

  Navigation();
  ~Navigation();

  /// Replaces a mesh of the same name. Fails at once if the configuration or the geometry is unusable; that nothing is
  /// walkable turns out at the first use. The value says whether parts of the geometry lie too far from the origin and
  /// are left out.
  Result<bool> Create(std::string_view name, NavigationGeometry geometry, const NavigationConfig& config);
  /// Waits for the mesh if it is being built. An error names what is wrong: no such mesh, or why it could not be built.
  Result<const NavigationMesh*> Find(std::string_view name);
  std::vector<std::string_view> Names() const;

  /// Shows the mesh in snapshots, or stops showing it. An error if none has this name or it could not be built.
  Result<void> Show(std::string_view name, bool show);
  void FillSnapshot(SceneSnapshot& snapshot) const;
  /// Draws all meshes that are ready, shown or not.
  void FillOverlay(OverlaySnapshot& overlays) const;
  /// What all meshes were made from. Waits for nothing.
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
