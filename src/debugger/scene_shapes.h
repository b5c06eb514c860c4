// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/imagery_rows.h"

namespace soarbox::debugger {

/// A node of an imagined scene as it is drawn over the world: edges and faces, in metres of the world. Edges and faces
/// are indices of `points`.
struct SceneShape {
  enum class Kind : std::uint8_t {
    kMadeUp,      ///< The mind created it; it is not fed by the world.
    kSensed,      ///< Fed by the world; the agent perceives it now.
    kRemembered,  ///< Fed by the world; it is at the position where the agent perceived it last.
  };
  std::string name, state;  ///< `state`: "S1", the state of the scene.
  Kind kind = Kind::kMadeUp;
  std::vector<ScenePoint> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< Empty for a ball that the world feeds; only its edges are
                                                    ///< drawn.
};

/// Maximum number of shapes that are drawn.
inline constexpr std::size_t kMostShapes = 200;

/// The shapes of a state's scene. With an empty `state`: the shapes that the mind created, in any scene, each with the
/// first state that has it. (Shapes that the world feeds have the tag solid.) Groups have no shape.
std::vector<SceneShape> ShapesOf(const ImageryView& view, std::string_view state);

/// Lines that show why the value of an extract is what it is.
struct AnswerLines {
  std::string text;  ///< The value: "1.4".
  std::vector<SceneLine> lines;
};
/// For the value with this record; empty if there is none now.
AnswerLines LinesOf(const ImageryView& view, std::string_view record);

}  // namespace soarbox::debugger
