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

#include "debugger/json.h"
#include "explain/inspector.h"
#include "explain/why_node.h"

namespace soarbox::debugger {

/// A point or a direction, in metres of the frame that the scene has (of the sandbox: the world's).
using ScenePoint = std::array<double, 3>;

/// A node of what a state imagines.
struct SceneNodeRow {
  std::string name;
  std::string parent;                      ///< Empty: it is the world.
  std::string shape;                       ///< "group", "hull", "ball".
  ScenePoint at{};                         ///< Its origin in the world.
  ScenePoint scale{1, 1, 1};               ///< In its own frame.
  std::array<double, 4> turn{0, 0, 0, 1};  ///< x, y, z, w.
  double radius = 0;                       ///< Of a ball, before scaling.
  std::vector<ScenePoint> points;          ///< Of a hull, in its own frame; 200 at most.
  std::map<std::string, std::string> tags;
  int depth = 0;  ///< Below the world, which has 0.
};

/// Two ends of a line that shows why a value is what it is.
struct SceneLine {
  ScenePoint from{}, to{};
  bool is_crossed = false;  ///< A sight line that something crosses.
};

/// What an extract found.
struct SceneValueRow {
  std::string record;              ///< Its identifier in working memory.
  std::string text;                ///< "1.4", "true", "box-1".
  explain::WhyNode why;            ///< What it was made from.
  std::vector<std::string> nodes;  ///< That it is about.
  std::vector<SceneLine> lines;
};

struct SceneExtractRow {
  std::string id, command, rule;  ///< "X7", "extract", the rule that gave it.
  std::string filter;             ///< Empty: it could not be read, or it is a command that changes the scene.
  std::string status, problem, hint;
  std::size_t count = 0;  ///< Of values; the first 40 of them are told.
  std::vector<SceneValueRow> values;
};

/// What one state imagines.
struct SceneView {
  std::string state;
  std::vector<SceneNodeRow> nodes;  ///< Each before its children.
  std::vector<SceneExtractRow> extracts;
};

/// What a mind imagines, state by state from the top.
struct ImageryView {
  std::string note;  ///< Why there is nothing; empty: there is something.
  std::vector<SceneView> scenes;
};

ImageryView LookAtImagery(explain::Inspector& mind);
/// Reads what `svs facts` prints; lines that make no sense are passed over.
ImageryView ReadImagery(std::string_view facts);
/// Why a record of an extract has its value: filters, nodes and values; nothing if no extract has such a record.
std::optional<explain::WhyNode> WhyRecord(explain::Inspector& mind, std::string_view record);

std::string ToText(const ImageryView& view);
Json ToJson(const ImageryView& view);

}  // namespace soarbox::debugger
