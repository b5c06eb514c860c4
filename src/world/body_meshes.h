// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <string_view>

#include "world/animation/rig.h"
#include "world/media_catalog.h"

namespace soarbox::world {

/// What a mesh with a skeleton looks like.
enum class BodyLook : std::uint8_t { kSoldier, kDarkSoldier, kRifle };

/// A mesh with a skeleton. The world uses this table to animate it, and viewers to draw it.
struct BodyMesh {
  std::string_view name;
  BodyLook look;
  const Rig& (*rig)();
  MeshBounds bounds;  ///< Contains the usual poses.
};

/// Includes the names that the sandbox uses and our own names.
inline constexpr std::array<BodyMesh, 6> kBodyMeshes{{
    {"models/futuristic_soldier/futuristic_soldier_anim.mesh",
     BodyLook::kSoldier,
     SoldierRig,
     {{-0.45f, 0, -0.5f}, {0.45f, 1.75f, 0.6f}}},
    {"models/futuristic_soldier/futuristic_soldier_dark_anim.mesh",
     BodyLook::kDarkSoldier,
     SoldierRig,
     {{-0.45f, 0, -0.5f}, {0.45f, 1.75f, 0.6f}}},
    {"models/futuristic_soldier/soldier_weapon.mesh",
     BodyLook::kRifle,
     RifleRig,
     {{-0.25f, -0.15f, -0.1f}, {0.7f, 0.2f, 0.02f}}},
    {"models/soarbox/soldier.mesh", BodyLook::kSoldier, SoldierRig, {{-0.45f, 0, -0.5f}, {0.45f, 1.75f, 0.6f}}},
    {"models/soarbox/soldier_dark.mesh",
     BodyLook::kDarkSoldier,
     SoldierRig,
     {{-0.45f, 0, -0.5f}, {0.45f, 1.75f, 0.6f}}},
    {"models/soarbox/rifle.mesh", BodyLook::kRifle, RifleRig, {{-0.25f, -0.15f, -0.1f}, {0.7f, 0.2f, 0.02f}}},
}};

/// Null if no mesh with a skeleton has this name.
inline const BodyMesh* FindBodyMesh(std::string_view name) {
  for (const BodyMesh& mesh : kBodyMeshes) {
    if (mesh.name == name) return &mesh;
  }
  return nullptr;
}

}  // namespace soarbox::world
