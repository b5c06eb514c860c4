// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "model/gltf_file.h"
#include "model/model.h"

namespace soarbox::model {

/// Transform of a node relative to its parent.
Frame FrameOfNode(GltfFile& file, const GltfFile::Json& node);
/// The same without shear.
world::BonePose PoseOfNode(GltfFile& file, const GltfFile::Json& node);

/// Reads the bones, skins and animations of a file into a model. A bone is a node that is a joint of a skin, that an
/// animation moves, or that has such a node below it. Errors are reported to the file. Used by gltf.cpp.
class GltfRig {
 public:
  GltfRig(GltfFile& file, Model& model) : file_(file), model_(model) {}

  /// Reads the bones and animations. `roots`: the nodes of the scene. Call it first, with depths and numbers of nodes
  /// that were checked. The model gets no bones if nothing of the file moves.
  void Read(const std::vector<std::uint64_t>& roots);
  bool moves() const { return !model_.rig.skeleton.bones().empty(); }
  /// The bone of a node; nothing if the node is none.
  std::optional<std::uint16_t> BoneOf(std::uint64_t node) const;

  /// The joints that move a mesh.
  struct Binding {
    std::vector<std::uint8_t> joints;  ///< Indices of Model::joints, in the order of the skin.
    std::vector<Frame> rest;           ///< By index in `joints`: from the space of the skin to the model at rest.
    Frame to_skin;                     ///< From the space of the mesh to the space of the skin.
  };
  /// For meshes with a skin.
  Binding BindSkin(std::uint64_t skin);
  /// For meshes that a bone carries, or none; `in_bone`: from the space of the mesh to that of the bone or the model.
  Binding BindBone(std::optional<std::uint16_t> bone, const Frame& in_bone);

 private:
  void FindMovingNodes();
  bool MarkBones(std::uint64_t node);
  void AddBones(std::uint64_t node, int parent);
  void ReadAnimation(std::size_t index);
  template <typename T>
  void ReadTrack(const GltfFile::Json& sampler, const std::string& what, world::BoneTrack<T>& track, float& length_s);
  std::string FreeName(const GltfFile::Json& animation, std::size_t index) const;
  std::uint8_t AddJoint(const Joint& joint);

  GltfFile& file_;
  Model& model_;
  std::set<std::uint64_t> moving_;  ///< Nodes that are joints or are animated; then also the nodes above them.
  std::map<std::uint64_t, std::uint16_t> bones_;
  std::map<std::uint64_t, Binding> skins_;
  std::map<int, std::uint8_t> rigid_;  ///< The joints of meshes without a skin, by bone; -1: without a bone.
  std::size_t keys_ = 0;
};

}  // namespace soarbox::model
