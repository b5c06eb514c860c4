// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "diagnostics/result.h"
#include "model/model.h"

namespace soarbox::model {

/// Maximum numbers of one model.
inline constexpr std::size_t kMostCorners = 200'000;
inline constexpr std::size_t kMostIndices = 600'000;

/// Reads a file next to the model: a buffer or a texture. `name` is relative to the model's folder.
using ReadNeighbour = std::function<Result<std::string>(std::string_view name)>;

/// Reads a glTF 2.0 model, as .glb or .gltf. The file may come from anywhere: each number in it is checked, and the
/// error says what is wrong.
///
/// What is read: the default scene with its nodes (matrix, or translation, rotation and scale), meshes of triangles
/// (also strips and fans) with positions, normals (computed if absent), vertex colours and indices; of materials the
/// base colour and its texture, a PNG, which is sampled at the corners. Buffers may be in the file, in data URIs or in
/// files beside it. What is ignored: skins, animations, morph targets, cameras, lights, and everything else of
/// materials. What is refused: files that require an extension, sparse accessors, JPEG textures.
Result<Model> ReadGltf(std::string_view file, const ReadNeighbour& neighbour);

}  // namespace soarbox::model
