// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/fill_batch.h"

namespace soarbox::viewer {
namespace {

struct FillCorner {
  float place[3];
  std::uint8_t colour[4];
};

std::uint8_t ChannelByte(float value) {
  return static_cast<std::uint8_t>(std::min(std::max(value, 0.0f), 1.0f) * 255.0f + 0.5f);
}

}  // namespace

FillBatch::FillBatch(const Ogre::MaterialPtr& material) : Ogre::SimpleRenderable("Soarbox/Fills") {
  mRenderOp.operationType = Ogre::RenderOperation::OT_TRIANGLE_LIST;
  mRenderOp.useIndexes = false;
  mRenderOp.vertexData = new Ogre::VertexData();  // Owned here; Ogre's render operation is a plain struct.
  Ogre::VertexDeclaration* layout = mRenderOp.vertexData->vertexDeclaration;
  layout->addElement(0, offsetof(FillCorner, place), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
  layout->addElement(0, offsetof(FillCorner, colour), Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
  setMaterial(material);
  setCastShadows(false);
  setRenderQueueGroup(Ogre::RENDER_QUEUE_7);
  setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
  Reserve(256);
  setVisible(false);
}

FillBatch::~FillBatch() {
  delete mRenderOp.vertexData;
}

void FillBatch::Reserve(std::size_t triangles) {
  if (triangles <= capacity_) return;
  capacity_ = std::max(triangles, 2 * capacity_);
  mRenderOp.vertexData->vertexBufferBinding->setBinding(
      0, Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
             sizeof(FillCorner), 3 * capacity_, Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY_DISCARDABLE));
}

void FillBatch::Update(const std::vector<world::TriangleSnapshot>& triangles) {
  setVisible(!triangles.empty());
  if (triangles.empty()) return;
  Reserve(triangles.size());
  const auto buffer = mRenderOp.vertexData->vertexBufferBinding->getBuffer(0);
  auto* out = static_cast<FillCorner*>(
      buffer->lock(0, 3 * triangles.size() * sizeof(FillCorner), Ogre::HardwareBuffer::HBL_DISCARD));
  for (const auto& triangle : triangles) {
    const world::Color c = triangle.color;
    for (const world::Vec3 p : {triangle.a, triangle.b, triangle.c}) {
      *out++ = {{p.x, p.y, p.z}, {ChannelByte(c.r), ChannelByte(c.g), ChannelByte(c.b), ChannelByte(c.a)}};
    }
  }
  buffer->unlock();
  mRenderOp.vertexData->vertexStart = 0;
  mRenderOp.vertexData->vertexCount = 3 * triangles.size();
}

}  // namespace soarbox::viewer
