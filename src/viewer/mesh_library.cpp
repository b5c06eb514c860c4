// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/mesh_library.h"

#include <cstdio>
#include <utility>

#include "viewer/drawable_mesh.h"
#include "viewer/figure_meshes.h"
#include "viewer/shape_meshes.h"

namespace soarbox::viewer {
namespace {

using world::DrawableSnapshot;
using world::ShapeKind;

std::string Key(const DrawableSnapshot& d, bool agent_body) {
  if (d.shape == ShapeKind::kMesh) return "mesh/" + d.mesh.value();
  char text[160];
  std::snprintf(text, sizeof text, "shape/%d/%d/%.4g/%.4g/%.4g/%.3g/%.3g", static_cast<int>(d.shape),
                agent_body ? 1 : 0, d.size.x, d.size.y, d.size.z, d.texture_repeats.x, d.texture_repeats.y);
  // If the material is a thing or a creature, it has its own mesh.
  return IsFigure(d.material.value()) ? std::string(text) + "/" + d.material.value() : text;
}

}  // namespace

Ogre::MeshPtr UploadMesh(const std::string& name, const MeshData& data) {
  struct GpuVertex {
    float position[3], normal[3], uv[2];
    std::uint8_t paint[4];
  };
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::min(std::max(value, 0.0f), 1.0f) * 255.0f + 0.5f);
  };
  std::vector<GpuVertex> vertices;
  vertices.reserve(data.vertices.size());
  for (const MeshVertex& v : data.vertices) {
    vertices.push_back({{v.position.x, v.position.y, v.position.z},
                        {v.normal.x, v.normal.y, v.normal.z},
                        {v.u, v.v},
                        {byte(v.tint), byte(v.light), byte(v.gloss), 255}});
  }

  Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual(name, kGroup);
  Ogre::SubMesh* part = mesh->createSubMesh();
  part->useSharedVertices = false;
  part->vertexData = new Ogre::VertexData();  // Ogre's sub-mesh owns it.
  part->vertexData->vertexCount = vertices.size();
  Ogre::VertexDeclaration* layout = part->vertexData->vertexDeclaration;
  layout->addElement(0, offsetof(GpuVertex, position), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
  layout->addElement(0, offsetof(GpuVertex, normal), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
  layout->addElement(0, offsetof(GpuVertex, uv), Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
  layout->addElement(0, offsetof(GpuVertex, paint), Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
  auto& buffers = Ogre::HardwareBufferManager::getSingleton();
  auto vertex_buffer =
      buffers.createVertexBuffer(sizeof(GpuVertex), vertices.size(), Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  vertex_buffer->writeData(0, vertex_buffer->getSizeInBytes(), vertices.data(), true);
  part->vertexData->vertexBufferBinding->setBinding(0, vertex_buffer);
  auto index_buffer = buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, data.indices.size(),
                                                Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
  index_buffer->writeData(0, index_buffer->getSizeInBytes(), data.indices.data(), true);
  part->indexData->indexBuffer = index_buffer;
  part->indexData->indexCount = data.indices.size();

  const Bounds bounds = BoundsOf(data);
  mesh->_setBounds(Ogre::AxisAlignedBox(ToOgre(bounds.min), ToOgre(bounds.max)), false);
  mesh->_setBoundingSphereRadius(std::max(world::Length(bounds.min), world::Length(bounds.max)));
  mesh->load();
  return mesh;
}

const MeshLibrary::Found& MeshLibrary::For(const DrawableSnapshot& drawable, bool agent_body) {
  const std::string key = Key(drawable, agent_body);
  const auto known = meshes_.find(key);
  if (known != meshes_.end()) return known->second;
  Found found;
  const DrawableMesh made = MeshOf(drawable, agent_body);
  found.is_stand_in = made.is_stand_in;
  found.material = made.data.material;
  found.levels.push_back(UploadMesh("Soarbox/" + key, made.data));
  if (agent_body && drawable.shape == ShapeKind::kCapsule && !IsFigure(drawable.material.value())) {
    // Coarser bodies at larger distances, for crowds.
    constexpr std::pair<AgentDetail, const char*> kFurther[] = {
        {AgentDetail::kMiddle, "/middle"}, {AgentDetail::kCoarse, "/coarse"}, {AgentDetail::kTiny, "/tiny"}};
    for (const auto& [detail, ending] : kFurther)
      found.levels.push_back(
          UploadMesh("Soarbox/" + key + ending, AgentMesh(drawable.size.x, drawable.size.y, detail)));
  }
  return meshes_.emplace(key, std::move(found)).first->second;
}

}  // namespace soarbox::viewer
