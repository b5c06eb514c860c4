// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// What many things share: their vertices and triangles, owned by whoever made them.
struct SharedShape {
  const Ogre::VertexData* vertices = nullptr;
  const Ogre::IndexData* corners = nullptr;
};

/// All things of one shape and material in one draw call for each camera: of the picture and of the shadow maps. Each
/// thing has some rows of four numbers, which the vertex program reads as uv1, uv2 and so on (Placing). A camera that
/// does not see a thing does not draw it.
class InstanceBatch : public Ogre::SimpleRenderable {
 public:
  /// rows: of each thing, at most kMostRows.
  InstanceBatch(Ogre::SceneManager& scene, const SharedShape& shape, std::size_t rows);
  ~InstanceBatch() override;
  InstanceBatch(const InstanceBatch&) = delete;
  InstanceBatch& operator=(const InstanceBatch&) = delete;

  static constexpr std::size_t kMostRows = 3;
  /// Where a thing is drawn.
  enum class Shown : std::uint8_t { kEverywhere, kInPicture, kInShadow };

  /// Begins the things of a frame.
  void Begin() { things_.clear(), rows_.clear(); }
  /// centre, radius_m: a ball around the thing. rows: the batch's number of rows.
  void Add(world::Vec3 centre, float radius_m, Shown shown, const Ogre::Vector4* rows);
  /// All things are there; without any it is not drawn.
  void End();

  std::size_t things() const { return things_.size(); }

  Ogre::Real getBoundingRadius() const override { return mBox.isFinite() ? mBox.getHalfSize().length() : 0; }
  Ogre::Real getSquaredViewDepth(const Ogre::Camera* camera) const override {
    return (camera->getDerivedPosition() - mBox.getCenter()).squaredLength();
  }
  void _updateRenderQueue(Ogre::RenderQueue* queue) override;

 private:
  struct Thing {
    Ogre::Sphere ball;
    Shown shown = Shown::kEverywhere;
  };

  Ogre::SceneManager& scene_;
  const std::size_t rows_of_each_;
  std::vector<Thing> things_;
  std::vector<Ogre::Vector4> rows_;  ///< Of all things.
  Ogre::HardwareVertexBufferSharedPtr seen_;
  std::size_t capacity_ = 0;  ///< Things that fit into `seen_`.
};

}  // namespace soarbox::viewer
