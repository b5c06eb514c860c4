// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/instance_batch.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace soarbox::viewer {

namespace {

/// Index of the buffer with the rows of the things; the buffers of the shape come first.
constexpr unsigned short kThingSource = 1;

/// The area of the finer shadow map, as seen from the sun.
struct NearMap {
  Ogre::Vector3 middle, right, up;
  float inner_m;  ///< Up to this distance from the centre the coarser map is not used (SunLit in
                  ///< media/shaders/scene.glsl).

  /// Whether a thing and its shadow, which coincide in this view, need only the finer map.
  bool Holds(const Ogre::Sphere& ball) const {
    const Ogre::Vector3 away = ball.getCenter() - middle;
    return std::abs(away.dotProduct(right)) + ball.getRadius() < inner_m &&
           std::abs(away.dotProduct(up)) + ball.getRadius() < inner_m;
  }
};

/// Returns the finer map if the camera draws the coarser one.
std::optional<NearMap> NearMapBefore(Ogre::SceneManager& scene, const Ogre::Camera& camera) {
  constexpr float kInner = 0.82f;
  const Ogre::TexturePtr& texture = scene.getShadowTexture(0);
  if (!texture) return std::nullopt;
  const Ogre::Camera* near = texture->getBuffer()->getRenderTarget()->getViewport(0)->getCamera();
  if (near == nullptr || near == &camera) return std::nullopt;
  return NearMap{near->getDerivedPosition(), near->getDerivedRight(), near->getDerivedUp(),
                 kInner * near->getOrthoWindowWidth() / 2};
}

}  // namespace

InstanceBatch::InstanceBatch(Ogre::SceneManager& scene, const SharedShape& shape, std::size_t rows)
    : Ogre::SimpleRenderable(), scene_(scene), rows_of_each_(std::min(rows, kMostRows)) {
  mRenderOp.operationType = Ogre::RenderOperation::OT_TRIANGLE_LIST;
  mRenderOp.useIndexes = true;
  mRenderOp.useGlobalInstancingVertexBufferIsAvailable = false;
  mRenderOp.vertexData = shape.vertices->clone(false);  // Owned here; Ogre's render operation is a plain struct.
  mRenderOp.indexData = shape.corners->clone(false);
  for (std::size_t row = 0; row < rows_of_each_; ++row) {
    mRenderOp.vertexData->vertexDeclaration->addElement(kThingSource, row * sizeof(Ogre::Vector4), Ogre::VET_FLOAT4,
                                                        Ogre::VES_TEXTURE_COORDINATES,
                                                        static_cast<unsigned short>(row + 1));
  }
  setVisible(false);
}

InstanceBatch::~InstanceBatch() {
  delete mRenderOp.vertexData;
  delete mRenderOp.indexData;
}

void InstanceBatch::Add(world::Vec3 centre, float radius_m, Shown shown, const Ogre::Vector4* rows) {
  things_.push_back({Ogre::Sphere(ToOgre(centre), radius_m), shown});
  rows_.insert(rows_.end(), rows, rows + rows_of_each_);
}

void InstanceBatch::End() {
  setVisible(!things_.empty());
  if (things_.empty()) return;
  Ogre::AxisAlignedBox box;
  for (const Thing& thing : things_)
    box.merge(Ogre::AxisAlignedBox(thing.ball.getCenter() - thing.ball.getRadius(),
                                   thing.ball.getCenter() + thing.ball.getRadius()));
  setBoundingBox(box);
  if (getParentSceneNode() != nullptr) getParentSceneNode()->needUpdate();
  if (things_.size() <= capacity_) return;
  capacity_ = std::max(things_.size(), 2 * capacity_);
  seen_ = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
      rows_of_each_ * sizeof(Ogre::Vector4), capacity_, Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY_DISCARDABLE);
  seen_->setIsInstanceData(true);
  seen_->setInstanceDataStepRate(1);
  mRenderOp.vertexData->vertexBufferBinding->setBinding(kThingSource, seen_);
}

void InstanceBatch::_updateRenderQueue(Ogre::RenderQueue* queue) {
  // Each camera draws its queue before the next camera begins, so the buffer can be reused.
  const bool is_shadow = scene_._getCurrentRenderStage() == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE;
  const Shown only = is_shadow ? Shown::kInShadow : Shown::kInPicture;
  const std::optional<NearMap> near = is_shadow ? NearMapBefore(scene_, *mCamera) : std::nullopt;
  const auto is_seen = [&](const Thing& thing) {
    return (thing.shown == Shown::kEverywhere || thing.shown == only) && mCamera->isVisible(thing.ball) &&
           !(near && near->Holds(thing.ball));
  };
  Ogre::Vector4* out = nullptr;
  std::size_t count = 0;
  for (std::size_t i = 0; i < things_.size(); ++i) {
    if (!is_seen(things_[i])) continue;
    if (out == nullptr)
      out = static_cast<Ogre::Vector4*>(
          seen_->lock(0, things_.size() * rows_of_each_ * sizeof(Ogre::Vector4), Ogre::HardwareBuffer::HBL_DISCARD));
    std::copy_n(rows_.begin() + static_cast<std::ptrdiff_t>(i * rows_of_each_), rows_of_each_,
                out + count * rows_of_each_);
    ++count;
  }
  if (out == nullptr) return;
  seen_->unlock();
  mRenderOp.numberOfInstances = count;
  Ogre::SimpleRenderable::_updateRenderQueue(queue);
}

}  // namespace soarbox::viewer
