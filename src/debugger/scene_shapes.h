// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/imagery.h"

namespace soarbox::debugger {

/// A node of what a mind imagines as it is drawn over the world: wire and skin, in metres of the world. Numbers count
/// `points` from 0.
struct SceneShape {
  enum class Kind : std::uint8_t {
    kMadeUp,      ///< The world did not feed it.
    kSensed,      ///< It is noticed now.
    kRemembered,  ///< It stands where it was noticed last.
  };
  std::string name, state;  ///< "S1", whose scene it is in.
  Kind kind = Kind::kMadeUp;
  std::vector<ScenePoint> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< None of a ball that the world feeds: it is only wire.
};

/// At most so many shapes are drawn.
inline constexpr std::size_t kMostShapes = 200;

/// What a state imagines; `state` empty: what the mind made up in any (the shapes that the world did not feed: they
/// have no tag solid), each with the first state that has it. Groups have no shape.
std::vector<SceneShape> ShapesOf(const ImageryView& view, std::string_view state);

/// Lines that show why an answer has its value.
struct AnswerLines {
  std::string text;  ///< The value: "1.4".
  std::vector<SceneLine> lines;
};
/// Of the answer with this record; nothing if there is none now.
AnswerLines LinesOf(const ImageryView& view, std::string_view record);

Json ToJson(const SceneShape& shape);
Json ToJson(const SceneLine& line);

}  // namespace soarbox::debugger
