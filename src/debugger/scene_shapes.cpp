// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/scene_shapes.h"

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "world/physics_hull.h"

namespace soarbox::debugger {
namespace {

/// Half the length of the arms of the cross that represents a point.
constexpr double kPoint_m = 0.15;
constexpr std::uint32_t kRingPieces = 24;
constexpr int kMeridians = 12, kParallels = 6;

/// Transforms a point from a node's own coordinates to the world.
ScenePoint Placed(const SceneNodeRow& node, const ScenePoint& point) {
  const double qx = node.turn[0], qy = node.turn[1], qz = node.turn[2], qw = node.turn[3];
  const ScenePoint v{point[0] * node.scale[0], point[1] * node.scale[1], point[2] * node.scale[2]};
  // v + w t + q x t with t = 2 q x v
  const ScenePoint t{2 * (qy * v[2] - qz * v[1]), 2 * (qz * v[0] - qx * v[2]), 2 * (qx * v[1] - qy * v[0])};
  return {node.at[0] + v[0] + qw * t[0] + qy * t[2] - qz * t[1], node.at[1] + v[1] + qw * t[1] + qz * t[0] - qx * t[2],
          node.at[2] + v[2] + qw * t[2] + qx * t[1] - qy * t[0]};
}

void AddCross(const ScenePoint& at, SceneShape& shape) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto first = static_cast<std::uint32_t>(shape.points.size());
    for (const double side : {-kPoint_m, kPoint_m}) {
      ScenePoint end = at;
      end[axis] += side;
      shape.points.push_back(end);
    }
    shape.edges.push_back({first, first + 1});
  }
}

void AddHull(const SceneNodeRow& node, SceneShape& shape) {
  std::vector<world::Vec3> points;
  for (const ScenePoint& point : node.points) {
    const ScenePoint at = Placed(node, point);
    points.push_back({static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])});
  }
  const world::ConvexHull hull = world::HullAround(points);
  if (hull.points.size() < 2) return AddCross(hull.points.empty() ? node.at : Placed(node, node.points.front()), shape);
  for (const world::Vec3& at : hull.points) shape.points.push_back({at.x, at.y, at.z});
  shape.edges = hull.edges;
  shape.faces = hull.faces;
}

/// Adds three rings, and faces.
void AddBall(const SceneNodeRow& node, SceneShape& shape) {
  const auto angle = [](double share) { return 2 * std::numbers::pi * share; };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto first = static_cast<std::uint32_t>(shape.points.size());
    for (std::uint32_t i = 0; i < kRingPieces; ++i) {
      const double at = angle(static_cast<double>(i) / kRingPieces);
      ScenePoint point{};
      point[(axis + 1) % 3] = node.radius * std::cos(at);
      point[(axis + 2) % 3] = node.radius * std::sin(at);
      shape.points.push_back(Placed(node, point));
      shape.edges.push_back({first + i, first + (i + 1) % kRingPieces});
    }
  }
  if (shape.kind != SceneShape::Kind::kMadeUp) return;
  const auto first = static_cast<std::uint32_t>(shape.points.size());
  for (int down = 0; down <= kParallels; ++down) {
    const double polar = std::numbers::pi * down / kParallels;
    for (int round = 0; round < kMeridians; ++round) {
      const double at = angle(static_cast<double>(round) / kMeridians), wide = node.radius * std::sin(polar);
      shape.points.push_back(Placed(node, {wide * std::cos(at), node.radius * std::cos(polar), wide * std::sin(at)}));
    }
  }
  const auto point = [first](int down, int round) {
    return first + static_cast<std::uint32_t>(down * kMeridians + round % kMeridians);
  };
  for (int down = 0; down < kParallels; ++down) {
    for (int round = 0; round < kMeridians; ++round) {
      if (down > 0) shape.faces.push_back({point(down, round), point(down, round + 1), point(down + 1, round)});
      if (down + 1 < kParallels)
        shape.faces.push_back({point(down, round + 1), point(down + 1, round + 1), point(down + 1, round)});
    }
  }
}

bool IsFed(const SceneNodeRow& node) {
  return node.tags.contains("solid");
}

SceneShape ShapeOf(const SceneNodeRow& node, const std::string& state) {
  SceneShape shape;
  shape.name = node.name;
  shape.state = state;
  const auto visible = node.tags.find("visible");
  if (IsFed(node))
    shape.kind = visible != node.tags.end() && visible->second == "no" ? SceneShape::Kind::kRemembered
                                                                       : SceneShape::Kind::kSensed;
  if (node.shape == "ball")
    AddBall(node, shape);
  else
    AddHull(node, shape);
  return shape;
}

}  // namespace

std::vector<SceneShape> ShapesOf(const ImageryView& view, std::string_view state) {
  std::vector<SceneShape> shapes;
  std::set<std::string> above;
  for (const SceneView& scene : view.scenes) {
    std::set<std::string> here;
    for (const SceneNodeRow& node : scene.nodes) {
      here.insert(node.name);
      if (node.shape == "group" || shapes.size() >= kMostShapes) continue;
      // A substate begins with a copy of the scene above, which does not follow the world. So a node of the same name
      // there is not new, even if its position differs.
      const bool is_wanted = state.empty() ? !IsFed(node) && !above.contains(node.name) : scene.state == state;
      if (is_wanted) shapes.push_back(ShapeOf(node, scene.state));
    }
    above = std::move(here);
  }
  return shapes;
}

AnswerLines LinesOf(const ImageryView& view, std::string_view record) {
  if (record.empty()) return {};
  for (const SceneView& scene : view.scenes) {
    for (const SceneExtractRow& extract : scene.extracts) {
      for (const SceneValueRow& value : extract.values)
        if (value.record == record) return {value.text, value.lines};
    }
  }
  return {};
}

}  // namespace soarbox::debugger
