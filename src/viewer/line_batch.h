// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// Draws all lines of a frame in one draw call. Each line is a strip that the vertex shader widens in screen space, so
/// its width does not depend on the distance.
class LineBatch : public Ogre::SimpleRenderable {
 public:
  explicit LineBatch(const Ogre::MaterialPtr& material);
  ~LineBatch() override;

  /// Replaces the lines by `lines` and `extra`.
  void Update(const std::vector<world::LineSnapshot>& lines, const std::vector<world::LineSnapshot>& extra);

  Ogre::Real getBoundingRadius() const override { return 1e6f; }
  Ogre::Real getSquaredViewDepth(const Ogre::Camera*) const override { return 0; }

 private:
  void Reserve(std::size_t lines);

  std::size_t capacity_ = 0;
};

}  // namespace soarbox::viewer
