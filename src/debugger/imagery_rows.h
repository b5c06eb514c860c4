// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "explain/inspector.h"
#include "explain/why_node.h"

namespace soarbox::debugger {

/// A point or a direction, in metres, in the coordinates of the scene. The scenes of the sandbox use those of the
/// world.
using ScenePoint = std::array<double, 3>;

/// A node of a scene that a state imagines.
struct SceneNodeRow {
  std::string name;
  std::string parent;                      ///< Empty for the root, `world`.
  std::string shape;                       ///< "group", "hull", "ball".
  ScenePoint at{};                         ///< Its origin in the world.
  ScenePoint scale{1, 1, 1};               ///< In its own coordinates.
  std::array<double, 4> turn{0, 0, 0, 1};  ///< x, y, z, w.
  double radius = 0;                       ///< Radius of a ball, before scaling.
  std::vector<ScenePoint> points;          ///< Vertices of a hull, in its own coordinates; at most 200.
  std::map<std::string, std::string> tags;
  int depth = 0;  ///< Number of ancestors; 0 for the root.
};

/// A line that shows why a value is what it is.
struct SceneLine {
  ScenePoint from{}, to{};
  bool is_crossed = false;  ///< It is a sight line, and an object blocks it.
};

/// One value that an extract found.
struct SceneValueRow {
  std::string record;              ///< Its identifier in working memory.
  std::string text;                ///< "1.4", "true", "box-1".
  explain::WhyNode why;            ///< From what the value was computed.
  std::string given;               ///< The input of the filter: "^a self ^b box-1"; may be empty.
  std::vector<std::string> nodes;  ///< Names of the nodes that the value is about.
  std::vector<SceneLine> lines;
};

struct SceneExtractRow {
  std::string id, command, rule;  ///< "X7", "extract", and the rule that gave the command.
  std::string filter;             ///< Empty if the command changes the scene, or if it could not be parsed.
  std::string status, problem, hint;
  std::size_t count = 0;  ///< Total number of values; `values` has at most the first 40.
  std::vector<SceneValueRow> values;
};

/// The scene of one state.
struct SceneView {
  std::string state;
  std::vector<SceneNodeRow> nodes;  ///< Each before its children.
  std::vector<SceneExtractRow> extracts;
};

/// The scenes of a mind, from the top state down.
struct ImageryView {
  std::string note;  ///< Why there is no scene; empty if there is one.
  std::vector<SceneView> scenes;
};

ImageryView LookAtImagery(explain::Inspector& mind);
/// Parses the output of `svs facts`. Skips malformed lines.
ImageryView ReadImagery(std::string_view facts);
/// Explains the value of a record of an extract by filters, nodes and values. Returns nothing if no extract has such a
/// record.
std::optional<explain::WhyNode> WhyRecord(explain::Inspector& mind, std::string_view record);

std::string ToText(const ImageryView& view);

}  // namespace soarbox::debugger
