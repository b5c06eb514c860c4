// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// The vertices and triangles that many things share. The caller owns them.
struct SharedShape {
  const Ogre::VertexData* vertices = nullptr;
  const Ogre::IndexData* corners = nullptr;
};

/// Draws all things of one shape and material in one draw call for each camera, including the cameras of the shadow
/// maps. Each thing has rows of four numbers, which the vertex program reads as uv1, uv2 and so on (Placing). A camera
/// draws only the things in its view.
class InstanceBatch : public Ogre::SimpleRenderable {
 public:
  /// `rows`: number of rows of each thing, at most kMostRows.
  InstanceBatch(Ogre::SceneManager& scene, const SharedShape& shape, std::size_t rows);
  ~InstanceBatch() override;
  InstanceBatch(const InstanceBatch&) = delete;
  InstanceBatch& operator=(const InstanceBatch&) = delete;

  static constexpr std::size_t kMostRows = 3;
  /// The cameras that draw a thing.
  enum class Shown : std::uint8_t { kEverywhere, kInPicture, kInShadow };

  /// Removes the things of the previous frame.
  void Begin() { things_.clear(), rows_.clear(); }
  /// `centre` and `radius_m` are a sphere around the thing. `rows` points to the batch's number of rows.
  void Add(world::Vec3 centre, float radius_m, Shown shown, const Ogre::Vector4* rows);
  /// Call it after the last Add(). A batch without things is not drawn.
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
  std::vector<Ogre::Vector4> rows_;  ///< Of all things, in their order.
  Ogre::HardwareVertexBufferSharedPtr seen_;
  std::size_t capacity_ = 0;  ///< Number of things that fit into `seen_`.
};

}  // namespace soarbox::viewer
