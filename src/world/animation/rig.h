// SPDX-License-Identifier: BSD-2-Clause
#pragma once

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

  /// Index of a clip; -1 if there is no clip of that name.
  int FindClip(std::string_view name) const;
  std::vector<std::string_view> ClipNames() const;
  std::vector<std::string_view> BoneNames() const;
};

/// The soldier's rig: 1.75 m tall with its helmet, feet at the origin, facing +z.
const Rig& SoldierRig();
/// The soldier's rifle: the barrel along +x, up +y.
const Rig& RifleRig();

}  // namespace soarbox::world
