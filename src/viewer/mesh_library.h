// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "viewer/ogre_headers.h"
#include "viewer/shape_meshes.h"

namespace soarbox::viewer {

/// Uploads a mesh to the graphics card under this name.
Ogre::MeshPtr UploadMesh(const std::string& name, const MeshData& data);

/// Meshes of drawables. Each is built and uploaded once and shared by all equal drawables.
class MeshLibrary {
 public:
  struct Found {
    std::vector<Ogre::MeshPtr> levels;  ///< Finest first; agents have four, other things one.
    std::string material;               ///< The mesh's own material, for drawables without a material name.
    bool is_stand_in = false;           ///< The resource name is unknown; this is a box that shows this.
  };

  /// Returns the mesh of a drawable; `agent_body`: a capsule gets the shape of an agent.
  const Found& For(const world::DrawableSnapshot& drawable, bool agent_body);

 private:
  std::unordered_map<std::string, Found> meshes_;
};

}  // namespace soarbox::viewer
