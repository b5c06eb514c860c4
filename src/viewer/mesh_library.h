// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "viewer/ogre_headers.h"
#include "viewer/shape_meshes.h"

namespace soarbox::viewer {

/// Hands a mesh to the graphics card under this name.
Ogre::MeshPtr UploadMesh(const std::string& name, const MeshData& data);

/// Meshes by what a drawable asks for, each built and uploaded once and shared by all that look alike.
class MeshLibrary {
 public:
  struct Found {
    std::vector<Ogre::MeshPtr> levels;  ///< The finest first; agents have four, other things one.
    std::string material;               ///< Its own, for drawables that name none.
    bool is_stand_in = false;           ///< The resource name is unknown; this is a box that says so.
  };

  /// The mesh of a drawable; `agent_body` gives a capsule the look of an agent.
  const Found& For(const world::DrawableSnapshot& drawable, bool agent_body);

 private:
  std::unordered_map<std::string, Found> meshes_;
};

}  // namespace soarbox::viewer
