// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "viewer/body_mesh.h"
#include "viewer/instance_batch.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// The meshes of bodies with a skeleton: what all bodies of one look and detail share, made and uploaded once.
class BodyLibrary {
 public:
  const SharedShape& For(world::BodyLook look, BodyDetail detail);
  static const world::Skeleton& SkeletonOf(world::BodyLook look);

 private:
  struct Uploaded {
    std::unique_ptr<Ogre::VertexData> vertices;
    std::unique_ptr<Ogre::IndexData> corners;
    SharedShape shape;
  };
  std::map<std::pair<world::BodyLook, BodyDetail>, Uploaded> uploaded_;
};

/// A body as it is to be drawn.
struct PosedBody {
  SkinPlace place;
  std::vector<world::BonePose> bones;
};

/// The bones of all bodies of a frame, in one texture that vertex programs read (kBonesTexture).
class BoneTexture {
 public:
  BoneTexture();

  /// Begins the bodies of a frame.
  void Begin() { rows_.clear(); }
  /// Adds a body's bones and returns the place of its first row. The body has as many bones as its skeleton.
  float Add(const PosedBody& body, world::BodyLook look);
  /// Hands them to the renderer.
  void End();

 private:
  Ogre::TexturePtr texture_;
  std::vector<float> rows_;
  std::map<world::BodyLook, std::vector<world::BonePose>> to_bind_;  ///< From the model to each bone's own space.
};

/// A ball around a body in any pose.
inline constexpr float kBodyReach_m = 2.4f;

/// Adds a body to a batch of its look.
void AddBody(InstanceBatch& batch, const PosedBody& body, world::Color trim, float first_row,
             InstanceBatch::Shown shown);

}  // namespace soarbox::viewer
