// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/skinned_body.h"

namespace soarbox::viewer {
namespace {

struct PaintVertex {
  float uv[2];
  std::uint8_t paint[4];
};
constexpr std::size_t kPlaceBytes = 6 * sizeof(float);

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
  std::vector<PaintVertex> paint;
  for (const MeshVertex& v : shared.skin.mesh.vertices)
    paint.push_back({{v.u, v.v}, {Byte(v.tint), Byte(v.light), Byte(v.gloss), 255}});
  auto& buffers = Ogre::HardwareBufferManager::getSingleton();
  shared.paint =
      buffers.createVertexBuffer(sizeof(PaintVertex), paint.size(), Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  shared.paint->writeData(0, shared.paint->getSizeInBytes(), paint.data(), true);
  const auto& indices = shared.skin.mesh.indices;
  shared.indices = buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, indices.size(),
                                             Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  shared.indices->writeData(0, shared.indices->getSizeInBytes(), indices.data(), true);
  return shared;
}

SkinnedBody::SkinnedBody(const BodyLibrary::Shared& shared, const std::string& name) : shared_(shared) {
  const std::size_t count = shared.skin.mesh.vertices.size();
  mesh_ = Ogre::MeshManager::getSingleton().createManual(name, kGroup);
  Ogre::SubMesh* part = mesh_->createSubMesh();
  part->useSharedVertices = false;
  part->vertexData = new Ogre::VertexData();  // Ogre's sub-mesh owns it.
  part->vertexData->vertexCount = count;
  Ogre::VertexDeclaration* layout = part->vertexData->vertexDeclaration;
  layout->addElement(0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
  layout->addElement(0, 3 * sizeof(float), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
  layout->addElement(1, offsetof(PaintVertex, uv), Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
  layout->addElement(1, offsetof(PaintVertex, paint), Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
  places_ = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
      kPlaceBytes, count, Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY_DISCARDABLE);
  part->vertexData->vertexBufferBinding->setBinding(0, places_);
  part->vertexData->vertexBufferBinding->setBinding(1, shared.paint);
  part->indexData->indexBuffer = shared.indices;
  part->indexData->indexCount = shared.skin.mesh.indices.size();
  // Room for every pose, lying ones included.
  mesh_->_setBounds(Ogre::AxisAlignedBox(-1.6f, -0.4f, -1.6f, 1.6f, 2.2f, 1.6f), false);
  mesh_->_setBoundingSphereRadius(2.4f);
  mesh_->load();
}

SkinnedBody::~SkinnedBody() {
  Ogre::MeshManager::getSingleton().remove(mesh_);
}

void SkinnedBody::Move(const std::vector<world::BonePose>& bones) {
  if (bones == shown_ || static_cast<int>(bones.size()) != shared_.skeleton->count()) return;
  shown_ = bones;
  auto* out = static_cast<float*>(places_->lock(Ogre::HardwareBuffer::HBL_DISCARD));
  MoveSkin(shared_.skin, *shared_.skeleton, bones, out);
  places_->unlock();
}

}  // namespace soarbox::viewer
