// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "world/animation/clip.h"
#include "world/animation/skeleton.h"

namespace soarbox::world {

struct GaitTable;

/// The bones and animations that all bodies of one kind share.
struct Rig {
  Skeleton skeleton;
  std::vector<Clip> clips;
  std::vector<bool> is_lower_body;   ///< By bone: whether the walk moves it. Empty if the rig has no legs.
  const GaitTable* gaits = nullptr;  ///< The gaits by speed; null if it cannot walk.
  std::string model;                 ///< The key of the model from a file that it belongs to; empty: a built-in rig.

  /// Index of a clip; -1 if there is no clip of that name.
  int FindClip(std::string_view name) const;
  std::vector<std::string_view> ClipNames() const;
  std::vector<std::string_view> BoneNames() const;
};

/// The soldier's rig: 1.75 m tall with its helmet, feet at the origin, facing +z.
const Rig& SoldierRig();
/// The soldier's rifle: the barrel along +x, up +y.
const Rig& RifleRig();

// The rigs of models from files. Like the models (model/model.h), they are stored for all worlds of the process and
// never removed. Any thread may call.

/// Stores the rig of the model with the key `rig.model`, unless it is stored already.
void KeepRig(Rig rig);
/// The rig of a model by its key; null if the model has none.
const Rig* FindRig(std::string_view model);
/// A rig without bones and animations, for models that are not available.
const Rig& EmptyRig();

/// The rig of a mesh: of a built-in one (world/body_meshes.h) or of a model; null if it has no skeleton.
const Rig* RigOfMesh(std::string_view mesh);

}  // namespace soarbox::world
