// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <string_view>

#include "world/media_catalog.h"

namespace soarbox::world {

enum class SceneryKind : std::uint8_t { kPine, kOak, kRock };

/// Plants and rocks, with their origins on the ground. Their bodies are the boxes of `bounds`. The boxes of trees are
/// as thin as their trunks, so that agents can pass below the branches.
struct SceneryMesh {
  std::string_view name;
  SceneryKind kind;
  float size_m;        ///< Height of a tree, width of a rock.
  std::uint32_t seed;  ///< Seed of its shape.
  MeshBounds bounds;
};

inline constexpr std::array<SceneryMesh, 8> kSceneryMeshes{{
    {"models/soarbox/pine_1.mesh", SceneryKind::kPine, 6.0f, 1, {{-0.2f, 0, -0.2f}, {0.2f, 6.0f, 0.2f}}},
    {"models/soarbox/pine_2.mesh", SceneryKind::kPine, 8.5f, 2, {{-0.25f, 0, -0.25f}, {0.25f, 8.5f, 0.25f}}},
    {"models/soarbox/oak_1.mesh", SceneryKind::kOak, 6.0f, 3, {{-0.25f, 0, -0.25f}, {0.25f, 6.0f, 0.25f}}},
    {"models/soarbox/oak_2.mesh", SceneryKind::kOak, 7.5f, 4, {{-0.3f, 0, -0.3f}, {0.3f, 7.5f, 0.3f}}},
    {"models/soarbox/rock_1.mesh", SceneryKind::kRock, 0.9f, 5, {{-0.42f, 0, -0.40f}, {0.42f, 0.55f, 0.40f}}},
    {"models/soarbox/rock_2.mesh", SceneryKind::kRock, 1.8f, 6, {{-0.84f, 0, -0.80f}, {0.84f, 1.10f, 0.80f}}},
    {"models/soarbox/rock_3.mesh", SceneryKind::kRock, 3.2f, 7, {{-1.50f, 0, -1.40f}, {1.50f, 1.95f, 1.40f}}},
    {"models/soarbox/rock_4.mesh", SceneryKind::kRock, 2.4f, 8, {{-1.10f, 0, -1.05f}, {1.10f, 1.45f, 1.05f}}},
}};

}  // namespace soarbox::world
