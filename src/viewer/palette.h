// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// How a named material looks. Colours as on the screen.
struct Look {
  /// kCorners: each corner brings its own colour, as u, v and light (models from files).
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
  float glow = 0;  ///< Light of its own.
  Paint paint = Paint::kPlain;
  float repeats = 1;  ///< Of the paint per unit of uv.
};

/// The look of a material name that scripts use ("Ground2", "Red", ...); false if we know no such name.
bool FindLook(std::string_view name, Look& look);

/// The colour that tells the kinds of agents apart, the same for bodies, labels and panels. Kinds that we do not know
/// get a colour by their name.
world::Color AgentColor(std::string_view kind);

/// The colour that soldiers of a team wear on helmets and arms. An empty team has a dull one.
world::Color TeamColor(std::string_view team);

/// Whether a script gave an agent's body a colour of its own; "Ground2" and its like mean no more than "some texture".
bool IsAgentColorMaterial(std::string_view material);

}  // namespace soarbox::viewer
