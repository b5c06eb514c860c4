// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <vector>

#include "viewer/body_mesh.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// The meshes of bodies with a skeleton: what all bodies of one look and detail share, made once.
class BodyLibrary {
 public:
  struct Shared {
    SkinMesh skin;
    const world::Skeleton* skeleton = nullptr;
  };
  const Shared& For(world::BodyLook look, BodyDetail detail);

 private:
  std::map<std::pair<world::BodyLook, BodyDetail>, Shared> shared_;
};

/// A body as it is to be drawn.
struct PosedBody {
  std::uint32_t id = 0;
  SkinPlace place;
  std::vector<world::BonePose> bones;
};

/// All bodies of one look, detail and material, in one draw call however many they are. Their vertices follow their
/// bones here, on the processor; those who stand still cost nothing.
class BodyBatch : public Ogre::SimpleRenderable {
 public:
  explicit BodyBatch(const BodyLibrary::Shared& shared);
  ~BodyBatch() override;
  BodyBatch(const BodyBatch&) = delete;
  BodyBatch& operator=(const BodyBatch&) = delete;

  /// Begins the bodies of a frame.
  void Begin() { count_ = 0; }
  /// Adds a body. One that need not `hurry` is moved in every other frame only.
  void Add(const PosedBody& body, bool hurry);
  /// Hands them to the renderer; without any it is not drawn.
  void End();

  std::size_t bodies() const { return count_; }

  Ogre::Real getBoundingRadius() const override { return mBox.isFinite() ? mBox.getHalfSize().length() : 0; }
  Ogre::Real getSquaredViewDepth(const Ogre::Camera* camera) const override {
    return (camera->getDerivedPosition() - mBox.getCenter()).squaredLength();
  }

 private:
  void Reserve(std::size_t bodies);

  struct Slot {
    PosedBody shown;
    bool waited = false;
  };

  const BodyLibrary::Shared& shared_;
  Ogre::HardwareVertexBufferSharedPtr moving_;
  std::vector<float> corners_;  ///< Places and normals of all slots.
  std::vector<Slot> slots_;
  std::size_t count_ = 0, capacity_ = 0;
  bool changed_ = false;
};

}  // namespace soarbox::viewer
