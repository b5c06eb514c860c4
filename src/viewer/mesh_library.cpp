// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/mesh_library.h"

#include <cstdio>
#include <utility>

#include "viewer/figure_meshes.h"
#include "viewer/modular_meshes.h"
#include "viewer/scenery_meshes.h"
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
  // What is a thing or a creature by its material is a mesh of its own.
  return IsFigure(d.material.value()) ? std::string(text) + "/" + d.material.value() : text;
}

/// The extents of a box or a capsule; nothing for others.
world::Vec3 ExtentsOf(const DrawableSnapshot& d) {
  if (d.shape == ShapeKind::kBox) return d.size;
  return d.shape == ShapeKind::kCapsule ? world::Vec3{2 * d.size.x, d.size.y, 2 * d.size.x} : world::Vec3{};
}

MeshData Build(const DrawableSnapshot& d, bool agent_body, bool& is_stand_in) {
  if (auto figure = FigureMesh(d.material.value(), ExtentsOf(d))) return *figure;
  switch (d.shape) {
    case ShapeKind::kBox:
      return BoxMesh(d.size * -0.5f, d.size * 0.5f,
                     {.repeats_u = d.texture_repeats.x, .repeats_v = d.texture_repeats.y});
    case ShapeKind::kCapsule:
      return agent_body ? AgentMesh(d.size.x, d.size.y) : CapsuleMesh(d.size.x, d.size.y);
    case ShapeKind::kCylinder:
      return CylinderMesh(d.size.x, d.size.y);
    case ShapeKind::kPlane:
      return PlaneMesh(d.size.x, d.size.z, d.texture_repeats.x, d.texture_repeats.y);
    case ShapeKind::kSphere:
      return SphereMesh(d.size.x);
    case ShapeKind::kMesh:
      break;
  }
  if (auto modular = ModularMesh(d.mesh.value())) return *modular;
  if (auto scenery = SceneryMeshFor(d.mesh.value())) return *scenery;
  is_stand_in = true;
  MeshData box = BoxMesh({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
  box.material = "Soarbox/Missing";
  return box;
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
  const MeshData data = Build(drawable, agent_body, found.is_stand_in);
  found.material = data.material;
  found.levels.push_back(UploadMesh("Soarbox/" + key, data));
  if (agent_body && drawable.shape == ShapeKind::kCapsule && !IsFigure(drawable.material.value())) {
    // Crowds: further away, coarser bodies.
    constexpr std::pair<AgentDetail, const char*> kFurther[] = {
        {AgentDetail::kMiddle, "/middle"}, {AgentDetail::kCoarse, "/coarse"}, {AgentDetail::kTiny, "/tiny"}};
    for (const auto& [detail, ending] : kFurther)
      found.levels.push_back(
          UploadMesh("Soarbox/" + key + ending, AgentMesh(drawable.size.x, drawable.size.y, detail)));
  }
  return meshes_.emplace(key, std::move(found)).first->second;
}

}  // namespace soarbox::viewer
