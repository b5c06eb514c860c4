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
inline constexpr std::size_t kMostBones = 256, kMostJoints = 256;
inline constexpr std::size_t kMostClips = 64;
inline constexpr std::size_t kMostKeys = 200'000;
/// Largest coordinate. Further away nothing is drawn, and floats become coarse.
inline constexpr float kFarthest_m = 1e5f;
/// Longest animation.
inline constexpr float kLongest_s = 3600;

/// Reads a file next to the model: a buffer or a texture. `name` is relative to the model's folder.
using ReadNeighbour = std::function<Result<std::string>(std::string_view name)>;

/// Reads a glTF 2.0 model, as .glb or .gltf. The file is not trusted: each number in it is checked. The error names the
/// invalid part.
///
/// Read are the default scene with its nodes (matrix, or translation, rotation and scale); meshes of triangles, strips
/// and fans with positions, normals (computed if absent), vertex colours and indices; and the base colour of materials
/// with its texture, a PNG or JPEG, which is sampled at the corners. Buffers may be in the file, in data URIs or in
/// files next to it.
///
/// Also read are skins, with the first four joints of each corner, and animations of nodes: translation, rotation and
/// scale, linear and in steps. Splines are read as lines between their values. A scale that is uneven and below a
/// rotation causes no shear.
///
/// Morph targets, cameras, lights and all other properties of materials are ignored. Files that require an extension
/// and sparse accessors are refused.
Result<Model> ReadGltf(std::string_view file, const ReadNeighbour& neighbour);

}  // namespace soarbox::model
