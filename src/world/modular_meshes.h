// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <string_view>

#include "world/math.h"

namespace soarbox::world {

/// The size of a building piece, in m around its origin. The piece's body is this box.
struct ModularMesh {
  std::string_view name;
  Vec3 min, max;
};

/// The 34 building pieces of the sandbox, "models/nobiax_modular/<name>.mesh".
/// Two pieces have their origin near an edge: the cooling unit extends a little behind it and stays upright; the hangar
/// door ends in front of it and falls over.
inline constexpr std::array<ModularMesh, 34> kModularMeshes{{
    {"modular_block", {-0.41f, -0.32f, -0.40f}, {0.39f, 0.32f, 0.40f}},
    {"modular_brick_door", {-1.28f, -0.77f, -0.16f}, {1.28f, 1.79f, 0.16f}},
    {"modular_brick_double_window", {-1.28f, -1.29f, -0.16f}, {1.28f, 1.27f, 0.16f}},
    {"modular_brick_small_double_window", {-1.29f, -1.27f, -0.16f}, {1.27f, 1.29f, 0.16f}},
    {"modular_brick_small_window_1", {-1.28f, -1.28f, -0.16f}, {1.28f, 1.28f, 0.16f}},
    {"modular_brick_small_window_2", {-0.64f, -1.27f, -0.16f}, {0.64f, 1.29f, 0.16f}},
    {"modular_brick_window_1", {-1.29f, -1.28f, -0.16f}, {1.27f, 1.28f, 0.16f}},
    {"modular_brick_window_2", {-0.65f, -1.26f, -0.16f}, {0.63f, 1.30f, 0.16f}},
    {"modular_concrete_door", {-1.28f, -1.29f, -0.16f}, {1.28f, 1.27f, 0.16f}},
    {"modular_concrete_double_window", {-1.29f, -1.28f, -0.16f}, {1.27f, 1.28f, 0.16f}},
    {"modular_concrete_small_double_window", {-1.28f, -1.27f, -0.16f}, {1.28f, 1.29f, 0.16f}},
    {"modular_concrete_small_window_1", {-1.28f, -1.30f, -0.16f}, {1.28f, 1.26f, 0.16f}},
    {"modular_concrete_small_window_2", {-0.63f, -1.29f, -0.16f}, {0.65f, 1.27f, 0.16f}},
    {"modular_concrete_window_1", {-1.28f, -1.28f, -0.16f}, {1.28f, 1.28f, 0.16f}},
    {"modular_concrete_window_2", {-0.64f, -1.27f, -0.16f}, {0.64f, 1.29f, 0.16f}},
    {"modular_cooling", {-0.44f, -0.39f, -0.05f}, {0.44f, 0.41f, 0.40f}},
    {"modular_hangar_door", {-1.28f, -1.28f, -0.16f}, {1.28f, 1.28f, -0.005f}},
    {"modular_pillar_brick_1", {-0.32f, -1.28f, -0.32f}, {0.32f, 1.28f, 0.32f}},
    {"modular_pillar_brick_2", {-0.31f, -0.97f, -0.32f}, {0.33f, 0.95f, 0.32f}},
    {"modular_pillar_brick_3", {-0.31f, -0.64f, -0.32f}, {0.33f, 0.64f, 0.32f}},
    {"modular_pillar_concrete_1", {-0.31f, -1.29f, -0.32f}, {0.33f, 1.27f, 0.32f}},
    {"modular_pillar_concrete_2", {-0.32f, -0.96f, -0.32f}, {0.32f, 0.96f, 0.32f}},
    {"modular_pillar_concrete_3", {-0.32f, -0.63f, -0.32f}, {0.32f, 0.65f, 0.32f}},
    {"modular_roof", {-1.61f, -0.16f, -1.59f}, {1.56f, 0.16f, 1.58f}},
    {"modular_wall_brick_1", {-1.28f, -1.28f, -0.16f}, {1.28f, 1.28f, 0.16f}},
    {"modular_wall_brick_2", {-0.64f, -1.27f, -0.16f}, {0.64f, 1.29f, 0.16f}},
    {"modular_wall_brick_3", {-0.63f, -0.66f, -0.16f}, {0.65f, 0.62f, 0.16f}},
    {"modular_wall_brick_4", {-1.29f, -0.31f, -0.16f}, {1.27f, 0.33f, 0.16f}},
    {"modular_wall_brick_5", {-0.64f, -0.31f, -0.16f}, {0.64f, 0.33f, 0.16f}},
    {"modular_wall_concrete_1", {-1.28f, -1.27f, -0.16f}, {1.28f, 1.29f, 0.16f}},
    {"modular_wall_concrete_2", {-0.63f, -1.28f, -0.16f}, {0.65f, 1.28f, 0.16f}},
    {"modular_wall_concrete_3", {-0.63f, -0.63f, -0.16f}, {0.65f, 0.65f, 0.16f}},
    {"modular_wall_concrete_4", {-1.28f, -0.30f, -0.16f}, {1.28f, 0.34f, 0.16f}},
    {"modular_wall_concrete_5", {-0.63f, -0.31f, -0.16f}, {0.65f, 0.33f, 0.16f}},
}};

/// The opening of a wall with a door, as fractions of its width and height. It begins at the bottom.
struct Doorway {
  float left = 0.3f, right = 0.7f, top = 0.8f;
};

/// Whether a mesh is a wall with an open doorway: those named ..._door, except the hangar door, which is only a door.
constexpr bool HasDoorway(std::string_view mesh) {
  const auto is = [mesh](std::string_view name) { return mesh.find(name) != std::string_view::npos; };
  return is("modular_brick_door") || is("modular_concrete_door");
}

/// The three boxes of a wall around its doorway: two posts and the lintel between them.
constexpr std::array<ModularMesh, 3> AroundDoorway(Vec3 min, Vec3 max) {
  const Doorway hole;
  const float left = min.x + hole.left * (max.x - min.x), right = min.x + hole.right * (max.x - min.x);
  const float top = min.y + hole.top * (max.y - min.y);
  return {{{"left post", min, {left, max.y, max.z}},
           {"right post", {right, min.y, min.z}, max},
           {"lintel", {left, top, min.z}, {right, max.y, max.z}}}};
}

}  // namespace soarbox::world
