// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "model/model.h"
#include "viewer/body_mesh.h"
#include "viewer/instance_batch.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// The meshes of bodies with a skeleton, one for each look and detail, and those of models that move. Each is built and
/// uploaded once and shared by all bodies.
class BodyLibrary {
 public:
  const SharedShape& For(world::BodyLook look, BodyDetail detail);
  const SharedShape& For(const std::shared_ptr<const model::Model>& model);
  static const world::Skeleton& SkeletonOf(world::BodyLook look);

 private:
  struct Uploaded {
    std::unique_ptr<Ogre::VertexData> vertices;
    std::unique_ptr<Ogre::IndexData> corners;
    SharedShape shape;
  };
  struct BodyVertex;
  static void Upload(const std::vector<BodyVertex>& vertices, const std::vector<std::uint32_t>& indices,
                     Uploaded& made);

  std::map<std::pair<world::BodyLook, BodyDetail>, Uploaded> uploaded_;
  std::map<std::shared_ptr<const model::Model>, Uploaded> uploaded_models_;
};

/// A body in the pose in which it is drawn.
struct PosedBody {
  SkinPlace place;
  std::vector<world::BonePose> bones;
};

/// The bones of all bodies of a frame, in one texture that the vertex programs read (kBonesTexture).
class BoneTexture {
 public:
  BoneTexture();

  /// Removes the bodies of the previous frame.
  void Begin() { rows_.clear(); }
  /// Adds a body's bones and returns the index of its first row. `body` must have as many bones as its skeleton.
  float Add(const PosedBody& body, world::BodyLook look);
  /// The same for a model.
  float Add(const PosedBody& body, const model::Model& model);
  /// Uploads the rows to the renderer.
  void End();

 private:
  Ogre::TexturePtr texture_;
  std::vector<float> rows_;
  std::map<world::BodyLook, std::vector<world::BonePose>> to_bind_;  ///< Maps model space to the space of each bone.
};

/// Radius of a sphere that contains a body in any pose.
inline constexpr float kBodyReach_m = 2.4f;

/// Adds a body to the batch of its look.
void AddBody(InstanceBatch& batch, const PosedBody& body, world::Color trim, float first_row,
             InstanceBatch::Shown shown);

}  // namespace soarbox::viewer
