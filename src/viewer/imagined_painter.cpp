// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/imagined_painter.h"

#include <algorithm>
#include <utility>

#include "viewer/viewer.h"

namespace soarbox::viewer {
namespace {

using debugger::ScenePoint;
using debugger::SceneShape;
using world::Color;
using world::Vec3;

/// By SceneShape::Kind: imagined, sensed, remembered.
constexpr Color kWire[] = {{0.86f, 0.66f, 1, 0.95f}, {0.45f, 0.85f, 1, 0.8f}, {0.78f, 0.80f, 0.86f, 0.7f}};
constexpr float kSkin[] = {0.22f, 0.08f, 0.05f};
constexpr Color kAnswer{1, 0.88f, 0.3f, 1}, kCrossed{1, 0.32f, 0.2f, 0.9f};
/// Maximum number of names; more would hide the shapes.
constexpr std::size_t kMostTitles = 40;
constexpr float kEnd_m = 0.12f;

Vec3 At(const ScenePoint& point) {
  return {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])};
}

/// A name above a box, without a figure.
Ghost NameOver(std::string name, Vec3 low, Vec3 high, Color color) {
  Ghost ghost;
  ghost.name = std::move(name);
  ghost.is_name_only = true;
  ghost.position = (low + high) * 0.5f;
  ghost.height_m = high.y - low.y;
  ghost.color = color;
  ghost.opacity = 0.4f;
  return ghost;
}

void PaintShape(const SceneShape& shape, OverlayMarks& marks) {
  const auto kind = static_cast<std::size_t>(shape.kind);
  Color skin = kWire[kind];
  skin.a = kSkin[kind];
  for (const auto& edge : shape.edges)
    marks.lines.push_back({At(shape.points[edge[0]]), At(shape.points[edge[1]]), kWire[kind]});
  for (const auto& face : shape.faces)
    marks.triangles.push_back({At(shape.points[face[0]]), At(shape.points[face[1]]), At(shape.points[face[2]]), skin});
}

Ghost TitleOf(const SceneShape& shape) {
  Vec3 low = At(shape.points.front()), high = low;
  for (const ScenePoint& point : shape.points) {
    const Vec3 at = At(point);
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  return NameOver(shape.name + " \xc2\xb7 " + shape.state, low, high, kWire[static_cast<std::size_t>(shape.kind)]);
}

}  // namespace

void PaintImagined(const std::vector<SceneShape>& shapes, const debugger::AnswerLines& answer, OverlayMarks& marks) {
  std::size_t names = 0;
  for (const SceneShape& shape : shapes) {
    if (shape.points.empty()) continue;
    PaintShape(shape, marks);
    // Shapes from the world have a name there already.
    if (shape.kind != SceneShape::Kind::kSensed && ++names <= kMostTitles) marks.ghosts.push_back(TitleOf(shape));
  }
  for (const debugger::SceneLine& line : answer.lines) {
    const Vec3 from = At(line.from), to = At(line.to);
    const Color color = line.is_crossed ? kCrossed : kAnswer;
    marks.lines.push_back({from, to, color});
    for (const Vec3 end : {from, to})
      for (const Vec3 arm : {Vec3{kEnd_m, 0, 0}, Vec3{0, kEnd_m, 0}, Vec3{0, 0, kEnd_m}})
        marks.lines.push_back({end - arm, end + arm, color});
  }
  if (!answer.lines.empty()) {
    const debugger::SceneLine& line = answer.lines.front();
    const Vec3 middle = (At(line.from) + At(line.to)) * 0.5f;
    marks.ghosts.push_back(NameOver(answer.text, middle, middle, kAnswer));
  }
}

}  // namespace soarbox::viewer
