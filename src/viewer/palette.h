// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// The appearance of a named material. Colours are in sRGB, as on the screen.
struct Look {
  /// kCorners: each vertex stores its own colour as u, v and light (models from files).
  enum class Paint : std::uint8_t {
    kPlain,
    kGround,
    kConcrete,
    kBrick,
    kCrate,
    kCloth,
    kLeaves,
    kStone,
    kMissing,
    kCorners
  };
  world::Color base{0.86f, 0.86f, 0.86f, 1};  ///< Alpha below 1: see-through.
  world::Color trim{0.05f, 0.06f, 0.08f, 1};  ///< Of visors, glass and doors.
  float gloss = 0.25f;
  float glow = 0;  ///< Emitted light.
  Paint paint = Paint::kPlain;
  float repeats = 1;  ///< Repeats of the paint per unit of uv.
};

/// Finds the look of a material name that scripts use ("Ground2", "Red", ...). Returns false for an unknown name.
bool FindLook(std::string_view name, Look& look);

/// The colour of a kind of agents, the same for bodies, labels and panels. Unknown kinds get a colour that depends on
/// their name.
world::Color AgentColor(std::string_view kind);

/// The colour of a team on the helmets and arms of its soldiers. An empty team has a dull colour.
world::Color TeamColor(std::string_view team);

/// Whether a script gave an agent's body a specific colour. "Ground2" and similar names only mean "some texture".
bool IsAgentColorMaterial(std::string_view material);

}  // namespace soarbox::viewer
