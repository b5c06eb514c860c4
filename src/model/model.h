// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "model/frame.h"
#include "world/animation/rig.h"
#include "world/math.h"

namespace soarbox::model {

/// A corner of a model's triangles: metres, y up, facing +z; colours as on the screen, 0..1.
struct Corner {
  world::Vec3 position;
  world::Vec3 normal;
  float red = 1, green = 1, blue = 1;
};

/// A bone as skins use it: it moves corners that are given in the space of the skin.
struct Joint {
  static constexpr std::uint16_t kStill = 0xffff;
  std::uint16_t bone = kStill;  ///< Index in the rig's skeleton; kStill: it never moves.
  Frame inverse_bind;           ///< From the space of the skin to the space of the bone.
};

/// How joints move a corner.
struct CornerSkin {
  world::Vec3 position, normal;          ///< In the space of the skin.
  std::array<std::uint8_t, 4> joints{};  ///< Indices of Model::joints.
  std::array<float, 4> weights{};        ///< They add up to 1.
};

/// A model: triangles in the space of its file, counter-clockwise seen from outside; and what moves them.
struct Model {
  std::vector<Corner> corners;         ///< In the pose of the file's nodes.
  std::vector<std::uint32_t> indices;  ///< Three per triangle, each below corners.size().
  world::Vec3 min, max;                ///< The box around the corners.

  // For models with skins or animations only; otherwise these are empty.
  world::Rig rig;
  std::vector<Joint> joints;      ///< At most 256.
  std::vector<CornerSkin> skins;  ///< One for each corner.

  bool moves() const { return !skins.empty(); }
};

/// For each joint of a model that moves, the transform from the space of the skin to the space of the model. `bones`:
/// the poses of its bones; for those that are missing the pose of the file is used.
std::vector<Frame> FramesOfJoints(const Model& model, const std::vector<world::BonePose>& bones);

// One store serves all worlds of the process, as that of other files does (world/asset_store.h). Any thread may call.

/// Stores a model and returns its key: "duck.glb#0123456789abcdef", the name and a hash of the model. If the model
/// moves, its rig is stored, too (world/animation/rig.h).
std::string KeepModel(std::string_view name, Model model);

/// The model of a key; null if it was not stored in this process.
std::shared_ptr<const Model> FindModel(std::string_view key);

/// Whether a file of this name can be a model: .glb or .gltf.
bool IsModelName(std::string_view name);

}  // namespace soarbox::model
