// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// Draws all translucent triangles of a frame's debug drawing in one draw call.
class FillBatch : public Ogre::SimpleRenderable {
 public:
  explicit FillBatch(const Ogre::MaterialPtr& material);
  ~FillBatch() override;

  void Update(const std::vector<world::TriangleSnapshot>& triangles);

  Ogre::Real getBoundingRadius() const override { return 1e6f; }
  Ogre::Real getSquaredViewDepth(const Ogre::Camera*) const override { return 0; }

 private:
  void Reserve(std::size_t triangles);

  std::size_t capacity_ = 0;
};

}  // namespace soarbox::viewer
