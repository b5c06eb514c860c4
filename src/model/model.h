// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "world/math.h"

namespace soarbox::model {

/// A corner of a model's triangles: metres, y up, facing +z; colours as on the screen, 0..1.
struct Corner {
  world::Vec3 position;
  world::Vec3 normal;
  float red = 1, green = 1, blue = 1;
};

/// A model: triangles in the space of its file, counter-clockwise seen from outside.
struct Model {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> indices;  ///< Three per triangle, each below corners.size().
  world::Vec3 min, max;                ///< The box around the corners.
};

// One store serves all worlds of the process, as that of other files does (world/asset_store.h). Any thread may call.

/// Stores a model and returns its key: "duck.glb#0123456789abcdef", the name and a hash of the triangles.
std::string KeepModel(std::string_view name, Model model);

/// The model of a key; null if it was not stored in this process.
std::shared_ptr<const Model> FindModel(std::string_view key);

/// Whether a file of this name can be a model: .glb or .gltf.
bool IsModelName(std::string_view name);

}  // namespace soarbox::model
