// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/line_batch.h"

namespace soarbox::viewer {
namespace {

struct LineCorner {
  float here[3], there[3], side[2];
  std::uint8_t colour[4];
};

std::uint8_t Byte(float value) {
  return static_cast<std::uint8_t>(std::min(std::max(value, 0.0f), 1.0f) * 255.0f + 0.5f);
}

LineCorner* AddLine(LineCorner* out, const world::LineSnapshot& line) {
  const world::Vec3 a = line.from, b = line.to;
  for (int i = 0; i < 4; ++i) {
    const bool at_end = i >= 2;
    const world::Vec3 here = at_end ? b : a, there = at_end ? a : b;
    // The corners go around the strip: left and right of the start, right and left of the end.
    const float side = i == 0 || i == 3 ? -1.0f : 1.0f;
    *out++ = {{here.x, here.y, here.z},
              {there.x, there.y, there.z},
              {side, at_end ? 1.0f : 0.0f},
              {Byte(line.color.r), Byte(line.color.g), Byte(line.color.b), Byte(line.color.a)}};
  }
  return out;
}

}  // namespace

LineBatch::LineBatch(const Ogre::MaterialPtr& material) : Ogre::SimpleRenderable("Soarbox/Lines") {
  mRenderOp.operationType = Ogre::RenderOperation::OT_TRIANGLE_LIST;
  mRenderOp.useIndexes = true;
  mRenderOp.vertexData = new Ogre::VertexData();  // Owned here; Ogre's render operation is a plain struct.
  mRenderOp.indexData = new Ogre::IndexData();
  Ogre::VertexDeclaration* layout = mRenderOp.vertexData->vertexDeclaration;
  layout->addElement(0, offsetof(LineCorner, here), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
  layout->addElement(0, offsetof(LineCorner, there), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
  layout->addElement(0, offsetof(LineCorner, side), Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
  layout->addElement(0, offsetof(LineCorner, colour), Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
  setMaterial(material);
  setCastShadows(false);
  setRenderQueueGroup(Ogre::RENDER_QUEUE_8);
  setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
  Reserve(1024);
  setVisible(false);
}

LineBatch::~LineBatch() {
  delete mRenderOp.vertexData;
  delete mRenderOp.indexData;
}

void LineBatch::Reserve(std::size_t lines) {
  if (lines <= capacity_) return;
  capacity_ = std::max(lines, 2 * capacity_);
  auto& buffers = Ogre::HardwareBufferManager::getSingleton();
  mRenderOp.vertexData->vertexBufferBinding->setBinding(
      0, buffers.createVertexBuffer(sizeof(LineCorner), 4 * capacity_,
                                    Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY_DISCARDABLE));
  std::vector<std::uint32_t> indices;
  indices.reserve(6 * capacity_);
  for (std::uint32_t i = 0; i < 4 * capacity_; i += 4)
    indices.insert(indices.end(), {i, i + 1, i + 2, i, i + 2, i + 3});
  auto index_buffer = buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, indices.size(),
                                                Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  index_buffer->writeData(0, index_buffer->getSizeInBytes(), indices.data(), true);
  mRenderOp.indexData->indexBuffer = index_buffer;
}

void LineBatch::Update(const std::vector<world::LineSnapshot>& lines, const std::vector<world::LineSnapshot>& extra) {
  const std::size_t count = lines.size() + extra.size();
  setVisible(count > 0);
  if (count == 0) return;
  Reserve(count);
  const auto buffer = mRenderOp.vertexData->vertexBufferBinding->getBuffer(0);
  auto* out =
      static_cast<LineCorner*>(buffer->lock(0, count * 4 * sizeof(LineCorner), Ogre::HardwareBuffer::HBL_DISCARD));
  for (const auto& line : lines) out = AddLine(out, line);
  for (const auto& line : extra) out = AddLine(out, line);
  buffer->unlock();
  mRenderOp.vertexData->vertexStart = 0;
  mRenderOp.vertexData->vertexCount = 4 * count;
  mRenderOp.indexData->indexStart = 0;
  mRenderOp.indexData->indexCount = 6 * count;
}

}  // namespace soarbox::viewer
