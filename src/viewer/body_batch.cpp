// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/body_batch.h"

#include <cstring>

namespace soarbox::viewer {
namespace {

struct PaintVertex {
  float uv[2];
  std::uint8_t paint[4];
};
constexpr std::size_t kCornerFloats = 6;

std::uint8_t Byte(float value) {
  return static_cast<std::uint8_t>(std::min(std::max(value, 0.0f), 1.0f) * 255.0f + 0.5f);
}

}  // namespace

const BodyLibrary::Shared& BodyLibrary::For(world::BodyLook look, BodyDetail detail) {
  const auto [found, is_new] = shared_.try_emplace({look, detail});
  Shared& shared = found->second;
  if (!is_new) return shared;
  shared.skin = MakeBodyMesh(look, detail);
  shared.skeleton = look == world::BodyLook::kRifle ? &world::RifleRig().skeleton : &world::SoldierRig().skeleton;
  return shared;
}

BodyBatch::BodyBatch(const BodyLibrary::Shared& shared) : Ogre::SimpleRenderable(), shared_(shared) {
  mRenderOp.operationType = Ogre::RenderOperation::OT_TRIANGLE_LIST;
  mRenderOp.useIndexes = true;
  mRenderOp.vertexData = new Ogre::VertexData();  // Owned by us; Ogre's render operation is a plain struct.
  mRenderOp.indexData = new Ogre::IndexData();
  Ogre::VertexDeclaration* layout = mRenderOp.vertexData->vertexDeclaration;
  layout->addElement(0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
  layout->addElement(0, 3 * sizeof(float), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
  layout->addElement(1, offsetof(PaintVertex, uv), Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
  layout->addElement(1, offsetof(PaintVertex, paint), Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
  Reserve(2);
  setVisible(false);
}

BodyBatch::~BodyBatch() {
  delete mRenderOp.vertexData;
  delete mRenderOp.indexData;
}

void BodyBatch::Reserve(std::size_t bodies) {
  if (bodies <= capacity_) return;
  capacity_ = std::max(bodies, 2 * capacity_);
  const auto& vertices = shared_.skin.mesh.vertices;
  const auto& indices = shared_.skin.mesh.indices;
  auto& buffers = Ogre::HardwareBufferManager::getSingleton();
  corners_.resize(capacity_ * vertices.size() * kCornerFloats);
  slots_.resize(capacity_);
  moving_ = buffers.createVertexBuffer(kCornerFloats * sizeof(float), capacity_ * vertices.size(),
                                       Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY_DISCARDABLE);
  std::vector<PaintVertex> paint;
  std::vector<std::uint32_t> corners;
  paint.reserve(capacity_ * vertices.size());
  corners.reserve(capacity_ * indices.size());
  for (std::size_t body = 0; body < capacity_; ++body) {
    const auto first = static_cast<std::uint32_t>(body * vertices.size());
    for (const MeshVertex& v : vertices)
      paint.push_back({{v.u, v.v}, {Byte(v.tint), Byte(v.light), Byte(v.gloss), 255}});
    for (const std::uint32_t index : indices) corners.push_back(first + index);
  }
  const auto paint_buffer =
      buffers.createVertexBuffer(sizeof(PaintVertex), paint.size(), Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  paint_buffer->writeData(0, paint_buffer->getSizeInBytes(), paint.data(), true);
  const auto index_buffer = buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, corners.size(),
                                                      Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  index_buffer->writeData(0, index_buffer->getSizeInBytes(), corners.data(), true);
  mRenderOp.vertexData->vertexBufferBinding->setBinding(0, moving_);
  mRenderOp.vertexData->vertexBufferBinding->setBinding(1, paint_buffer);
  mRenderOp.indexData->indexBuffer = index_buffer;
  changed_ = true;
}

void BodyBatch::Add(const PosedBody& body, bool hurry) {
  if (static_cast<int>(body.bones.size()) != shared_.skeleton->count()) return;
  Reserve(count_ + 1);
  Slot& slot = slots_[count_];
  const std::size_t first = count_++ * shared_.skin.mesh.vertices.size() * kCornerFloats;
  if (slot.shown.id == body.id) {
    if (slot.shown.place == body.place && slot.shown.bones == body.bones) return;
    slot.waited = !slot.waited;
    if (!hurry && slot.waited) return;
  }
  slot.shown = body;
  MoveSkin(shared_.skin, *shared_.skeleton, body.bones, body.place, corners_.data() + first);
  changed_ = true;
}

void BodyBatch::End() {
  setVisible(count_ > 0);
  if (count_ == 0) return;
  const std::size_t vertices = count_ * shared_.skin.mesh.vertices.size();
  mRenderOp.vertexData->vertexStart = 0;
  mRenderOp.vertexData->vertexCount = vertices;
  mRenderOp.indexData->indexStart = 0;
  mRenderOp.indexData->indexCount = count_ * shared_.skin.mesh.indices.size();
  if (!changed_) return;
  changed_ = false;
  const std::size_t bytes = vertices * kCornerFloats * sizeof(float);
  std::memcpy(moving_->lock(0, bytes, Ogre::HardwareBuffer::HBL_DISCARD), corners_.data(), bytes);
  moving_->unlock();
  // Room for every pose, lying ones included.
  Ogre::AxisAlignedBox box;
  for (std::size_t i = 0; i < count_; ++i) {
    const Ogre::Vector3 at = ToOgre(slots_[i].shown.place.at.position);
    const float reach = 2.4f * std::max(1.0f, slots_[i].shown.place.scale.x);
    box.merge(Ogre::AxisAlignedBox(at - reach, at + reach));
  }
  setBoundingBox(box);
  if (getParentSceneNode() != nullptr) getParentSceneNode()->needUpdate();
}

}  // namespace soarbox::viewer
