// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/body_library.h"

#include <algorithm>
#include <cstddef>

#include "viewer/drawable_mesh.h"
#include "viewer/materials.h"

namespace soarbox::viewer {

struct BodyLibrary::BodyVertex {
  float position[3], normal[3], uv[2];
  std::uint8_t paint[4];
  std::uint8_t bones[4];
  std::uint8_t weights[4];  ///< Of the bones, in 255ths.
};

namespace {

/// Width of the texture, as in media/shaders/place.glsl; a texel contains a row.
constexpr std::size_t kWidth = 1024, kFloatsPerRow = 4, kRowsPerBone = 3;

std::uint8_t Byte255(float value) {
  return static_cast<std::uint8_t>(std::min(std::max(value, 0.0f), 1.0f) * 255.0f + 0.5f);
}

}  // namespace

const world::Skeleton& BodyLibrary::SkeletonOf(world::BodyLook look) {
  return look == world::BodyLook::kRifle ? world::RifleRig().skeleton : world::SoldierRig().skeleton;
}

const SharedShape& BodyLibrary::For(world::BodyLook look, BodyDetail detail) {
  const auto [found, is_new] = uploaded_.try_emplace({look, detail});
  Uploaded& made = found->second;
  if (!is_new) return made.shape;
  const SkinMesh skin = MakeBodyMesh(look, detail);
  std::vector<BodyVertex> vertices;
  vertices.reserve(skin.skin.size());
  for (std::size_t i = 0; i < skin.skin.size(); ++i) {
    const MeshVertex& v = skin.mesh.vertices[i];
    const SkinVertex& by = skin.skin[i];
    const std::uint8_t share = Byte255(by.share);
    vertices.push_back({{v.position.x, v.position.y, v.position.z},
                        {v.normal.x, v.normal.y, v.normal.z},
                        {v.u, v.v},
                        {Byte255(v.tint), Byte255(v.light), Byte255(v.gloss), 255},
                        {by.bone, by.other, 0, 0},
                        {share, static_cast<std::uint8_t>(255 - share), 0, 0}});
  }
  Upload(vertices, skin.mesh.indices, made);
  return made.shape;
}

const SharedShape& BodyLibrary::For(const std::shared_ptr<const model::Model>& model) {
  const auto [found, is_new] = uploaded_models_.try_emplace(model);
  if (!is_new) return found->second.shape;
  const MeshData mesh = ModelMesh(*model, true);
  std::vector<BodyVertex> vertices;
  vertices.reserve(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const MeshVertex& v = mesh.vertices[i];
    const auto& joints = model->skins[i].joints;
    const auto weights = WeightBytes(model->skins[i].weights);
    vertices.push_back({{v.position.x, v.position.y, v.position.z},
                        {v.normal.x, v.normal.y, v.normal.z},
                        {v.u, v.v},
                        {Byte255(v.tint), Byte255(v.light), Byte255(v.gloss), 255},
                        {joints[0], joints[1], joints[2], joints[3]},
                        {weights[0], weights[1], weights[2], weights[3]}});
  }
  Upload(vertices, mesh.indices, found->second);
  return found->second.shape;
}

void BodyLibrary::Upload(const std::vector<BodyVertex>& vertices, const std::vector<std::uint32_t>& indices,
                         Uploaded& made) {
  auto& buffers = Ogre::HardwareBufferManager::getSingleton();
  made.vertices = std::make_unique<Ogre::VertexData>();
  made.vertices->vertexCount = vertices.size();
  Ogre::VertexDeclaration* layout = made.vertices->vertexDeclaration;
  layout->addElement(0, offsetof(BodyVertex, position), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
  layout->addElement(0, offsetof(BodyVertex, normal), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
  layout->addElement(0, offsetof(BodyVertex, uv), Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
  layout->addElement(0, offsetof(BodyVertex, paint), Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
  layout->addElement(0, offsetof(BodyVertex, bones), Ogre::VET_UBYTE4_NORM, Ogre::VES_BLEND_INDICES);
  layout->addElement(0, offsetof(BodyVertex, weights), Ogre::VET_UBYTE4_NORM, Ogre::VES_BLEND_WEIGHTS);
  const auto vertex_buffer =
      buffers.createVertexBuffer(sizeof(BodyVertex), vertices.size(), Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  vertex_buffer->writeData(0, vertex_buffer->getSizeInBytes(), vertices.data(), true);
  made.vertices->vertexBufferBinding->setBinding(0, vertex_buffer);
  made.corners = std::make_unique<Ogre::IndexData>();
  made.corners->indexCount = indices.size();
  made.corners->indexBuffer = buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, indices.size(),
                                                        Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  made.corners->indexBuffer->writeData(0, made.corners->indexBuffer->getSizeInBytes(), indices.data(), true);
  made.shape = {made.vertices.get(), made.corners.get()};
}

BoneTexture::BoneTexture() {
  constexpr unsigned kFirstHeight = 8;
  texture_ =
      Ogre::TextureManager::getSingleton().createManual(kBonesTexture, kGroup, Ogre::TEX_TYPE_2D, kWidth, kFirstHeight,
                                                        0, Ogre::PF_FLOAT32_RGBA, Ogre::TU_DYNAMIC_WRITE_ONLY);
  for (const world::BodyLook look : {world::BodyLook::kSoldier, world::BodyLook::kDarkSoldier, world::BodyLook::kRifle})
    to_bind_[look] = ToBind(BodyLibrary::SkeletonOf(look));
}

float BoneTexture::Add(const PosedBody& body, world::BodyLook look) {
  const auto first = static_cast<float>(rows_.size() / kFloatsPerRow);
  rows_.resize(rows_.size() + body.bones.size() * kRowsPerBone * kFloatsPerRow);
  BoneRows(to_bind_[look], body.bones, body.place, &rows_[static_cast<std::size_t>(first) * kFloatsPerRow]);
  return first;
}

float BoneTexture::Add(const PosedBody& body, const model::Model& model) {
  const auto first = static_cast<float>(rows_.size() / kFloatsPerRow);
  const std::vector<float> rows = JointRows(model, body.bones, body.place);
  rows_.insert(rows_.end(), rows.begin(), rows.end());
  return first;
}

void BoneTexture::End() {
  if (rows_.empty()) return;
  const std::size_t lines = (rows_.size() / kFloatsPerRow + kWidth - 1) / kWidth;
  rows_.resize(lines * kWidth * kFloatsPerRow);
  if (lines > texture_->getHeight()) {
    texture_->freeInternalResources();
    texture_->setHeight(static_cast<Ogre::uint32>(2 * lines));
    texture_->createInternalResources();
  }
  const auto height = static_cast<Ogre::uint32>(lines);
  texture_->getBuffer()->blitFromMemory(
      Ogre::PixelBox(static_cast<Ogre::uint32>(kWidth), height, 1, Ogre::PF_FLOAT32_RGBA, rows_.data()),
      Ogre::Box(0, 0, static_cast<Ogre::uint32>(kWidth), height));
}

void AddBody(InstanceBatch& batch, const PosedBody& body, world::Color trim, float first_row,
             InstanceBatch::Shown shown) {
  const Ogre::Vector4 row(trim.r, trim.g, trim.b, first_row);
  const float largest =
      std::max({1.0f, std::abs(body.place.scale.x), std::abs(body.place.scale.y), std::abs(body.place.scale.z)});
  batch.Add(body.place.at.position, kBodyReach_m * largest, shown, &row);
}

}  // namespace soarbox::viewer
