// SPDX-License-Identifier: BSD-2-Clause
#include "cli/svs_paths.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "cli/scene_viewer.h"
#include "diagnostics/diagnostic.h"
#include "kernel/imagery/scene_lines.h"

namespace soarbox::cli {
namespace {

using kernel::Imagery;
using kernel::imagery::FilterKind;
using kernel::imagery::Node;
using kernel::imagery::NumberText;
using kernel::imagery::ParameterInfo;
using kernel::imagery::Scene;
using kernel::imagery::Shape;
using kernel::imagery::StateScene;
using kernel::imagery::Vec3;

constexpr std::string_view kNotFound = "path not found\n";

/// Lines of cells; each column has the width of its widest cell plus one blank.
class Columns {
 public:
  void Row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  void Row(std::string name, const Vec3& vector) {
    Row({std::move(name), NumberText(vector.x), NumberText(vector.y), NumberText(vector.z)});
  }
  std::string Text() const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t n = 0; n < row.size(); ++n) widths[n] = std::max(widths[n], row[n].size());
    }
    std::string text;
    for (const auto& row : rows_) {
      for (std::size_t n = 0; n < row.size(); ++n) text += row[n] + std::string(widths[n] - row[n].size() + 1, ' ');
      text += '\n';
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// The first name of a path, and the part after its dot.
std::pair<std::string_view, std::string_view> SplitPath(std::string_view path) {
  const std::size_t dot = path.find('.');
  if (dot == std::string_view::npos) return {path, {}};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

bool IsHere(std::string_view path) {
  return path.empty() || path == ".";
}

std::string Indent(int level, std::string_view name) {
  return std::string(static_cast<std::size_t>(level) * 2, ' ') + std::string(name) + "\n";
}

/// Children of nodes are listed by name.
std::vector<const Node*> ChildrenByName(const Node& node) {
  std::vector<const Node*> children;
  for (const auto& child : node.children()) children.push_back(child.get());
  std::sort(children.begin(), children.end(), [](const Node* a, const Node* b) { return a->id() < b->id(); });
  return children;
}

std::string ListBelow(const Node& node, int level) {
  std::string text;
  for (const Node* const child : ChildrenByName(node))
    text += Indent(level, child->id()) + ListBelow(*child, level + 1);
  return text;
}

std::string ListScene(const Scene& scene, int level) {
  std::string text;
  for (const std::string_view name : {"clear", "draw", "properties", "sgel", "world"}) text += Indent(level, name);
  return text + ListBelow(scene.root(), level + 1);
}

std::string TextOfNode(const Node& node) {
  Columns head;
  head.Row({"id:", node.id()});
  head.Row({"parent:", node.parent() == nullptr ? "none" : node.parent()->id()});
  Columns local;
  local.Row("pos:", node.pose().position);
  local.Row("rot:", node.pose().rotation);
  local.Row("scale:", node.pose().scale);
  const kernel::imagery::Transform::Parts parts = node.World().Decompose();
  Columns world;
  world.Row("pos:", parts.position);
  world.Row({"rot (quaternion):", NumberText(parts.rotation[0]), NumberText(parts.rotation[1]),
             NumberText(parts.rotation[2]), NumberText(parts.rotation[3])});
  world.Row("scale:", parts.scale);
  Columns tags;
  for (const auto& [name, value] : node.tags()) tags.Row({name, value});
  std::string text = head.Text() + "\nLocal transform:\n" + local.Text() + "\nWorld transform:\n" + world.Text() +
                     "\nTags:\n" + tags.Text();
  if (node.shape() == Shape::kBall) text += "\nradius: " + NumberText(node.radius()) + "\n";
  if (node.shape() == Shape::kHull) {
    Columns points;
    for (const Vec3& point : node.points()) {
      points.Row({NumberText(point.x), NumberText(point.y), NumberText(point.z)});
    }
    text += "\nvertices\n" + points.Text();
  }
  return text;
}

std::string Properties(const Scene& scene) {
  Columns columns;
  const auto rows = [&](const std::string& id, char letter, const Vec3& vector) {
    for (int axis = 0; axis < 3; ++axis) {
      columns.Row({id + ":" + letter + static_cast<char>('x' + axis), NumberText(vector[axis])});
    }
  };
  scene.ForEach([&](const Node& node) {
    rows(node.id(), 'p', node.pose().position);
    rows(node.id(), 'r', node.pose().rotation);
    rows(node.id(), 's', node.pose().scale);
    for (const auto& [name, value] : node.tags()) columns.Row({node.id() + ":" + name, value});
  });
  return columns.Text();
}

// Lists of kinds ------------------------------------------------------------------------------------------------------

template <typename Kind>
std::string TextOfKind(std::string_view what, const Kind& kind) {
  std::string text = std::string(what) + " " + std::string(kind.name) + ": " + std::string(kind.meaning) + "\n";
  Columns parameters;
  for (const ParameterInfo& parameter : kind.parameters) {
    parameters.Row({"  ^" + std::string(parameter.name),
                    (parameter.required ? "" : "[optional] ") + std::string(parameter.meaning)});
  }
  return text + parameters.Text();
}

template <typename Kinds>
std::string TextOfKinds(std::string_view what, const Kinds& kinds) {
  Columns rows;
  for (const auto& kind : kinds) rows.Row({std::string(kind.name), std::string(kind.meaning)});
  return rows.Text() + "\nFor the parameters of one, type svs " + std::string(what) + ".NAME\n";
}

std::string FormOf(const ParameterInfo& parameter) {
  switch (parameter.form) {
    case kernel::imagery::ParameterForm::kNodes:
      return "nodes";
    case kernel::imagery::ParameterForm::kNumber:
      return "number";
    case kernel::imagery::ParameterForm::kObject:
      return "object";
    case kernel::imagery::ParameterForm::kWord:
      break;
  }
  std::string words(parameter.words.empty() ? "word" : parameter.words);
  std::replace(words.begin(), words.end(), ' ', '|');
  return words;
}

template <typename Kinds>
std::string TableOfKinds(std::string_view what, const Kinds& kinds) {
  std::string text;
  for (const auto& kind : kinds) {
    text += std::string(what) + " " + std::string(kind.name) + ": " + std::string(kind.meaning) + "\n";
    for (const ParameterInfo& parameter : kind.parameters) {
      const std::string name = "^" + std::string(parameter.name);
      text += "  " + (parameter.required ? name : "[" + name + "]") + " " + FormOf(parameter) + ": " +
              std::string(parameter.meaning) + "\n";
    }
  }
  return text;
}

template <typename Kinds>
std::string UseKinds(std::string_view what, std::string_view word, const Kinds& kinds, std::string_view name,
                     std::span<const std::string> arguments) {
  const std::string_view argument = arguments.empty() ? std::string_view() : std::string_view(arguments[0]);
  if (!IsHere(name)) {
    for (const auto& kind : kinds) {
      if (kind.name == name) return TextOfKind(word, kind);
    }
    return {};
  }
  if (argument == "help") return "Lists the " + std::string(what) + " of the spatial visual system.\n";
  if (argument != "dir") return TextOfKinds(what, kinds);
  std::string text;
  for (const auto& kind : kinds) text += Indent(0, kind.name);
  return text;
}

}  // namespace

std::string AllSceneKinds() {
  return TableOfKinds("command", kernel::imagery::CommandKinds()) +
         TableOfKinds("filter", kernel::imagery::FilterKinds());
}

std::string SvsPaths::Fail(std::string text) {
  failed_ = true;
  return text;
}

std::string SvsPaths::Use(std::string_view path, Arguments arguments) {
  if (IsHere(path)) return UseRoot(arguments);
  const std::pair<std::string_view, std::string_view> split = SplitPath(path);
  const std::string_view first = split.first, rest = split.second;
  const auto is = [&](std::string_view name) {
    return std::equal(first.begin(), first.end(), name.begin(), name.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
  };
  if (is("filters")) {
    const std::string text = UseKinds("filters", "Filter", kernel::imagery::FilterKinds(), rest, arguments);
    if (!text.empty()) return text;
    std::vector<std::string_view> names;
    for (const FilterKind& kind : kernel::imagery::FilterKinds()) names.emplace_back(kind.name);
    const std::string near(Suggest(rest, names));
    return Fail("There is no filter " + std::string(rest) + (near.empty() ? "." : ": did you mean " + near + "?") +
                " Type svs filters for a list.\n");
  }
  if (is("commands")) {
    const std::string text = UseKinds("commands", "Command", kernel::imagery::CommandKinds(), rest, arguments);
    return text.empty() ? Fail("There is no command " + std::string(rest) + ". Type svs commands for a list.\n") : text;
  }
  if (is("connect_viewer") && IsHere(rest)) return Connect(arguments);
  if (is("disconnect_viewer") && IsHere(rest)) {
    if (!arguments.empty() && arguments[0] == "help") return "Disconnects the viewer.\n";
    imagery_.SetViewer({});
    return {};
  }
  std::string name(first);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  StateScene* const state = imagery_.FindState(name);
  return state == nullptr ? std::string(kNotFound) : UseState(*state, rest, arguments);
}

std::string SvsPaths::UseRoot(Arguments arguments) {
  if (!arguments.empty() && arguments[0] == "help") return {};
  // In alphabetical order: states come first, because their names are in upper case.
  std::vector<StateScene*> states;
  for (const auto& state : imagery_.states()) states.push_back(state.get());
  std::sort(states.begin(), states.end(),
            [](StateScene* a, StateScene* b) { return a->scene().name() < b->scene().name(); });
  std::string text;
  for (StateScene* const state : states) {
    text += Indent(0, state->scene().name()) + Indent(1, "scene") + ListScene(state->scene(), 2);
  }
  text += Indent(0, "commands");
  for (const auto& kind : kernel::imagery::CommandKinds()) text += Indent(1, kind.name);
  text += Indent(0, "connect_viewer") + Indent(0, "disconnect_viewer") + Indent(0, "filters");
  for (const FilterKind& kind : kernel::imagery::FilterKinds()) text += Indent(1, kind.name);
  return text;
}

std::string SvsPaths::UseState(StateScene& state, std::string_view rest, Arguments arguments) {
  if (IsHere(rest)) {
    if (!arguments.empty() && arguments[0] == "help") return {};
    return Indent(0, "scene") + ListScene(state.scene(), 1);
  }
  const auto [name, below] = SplitPath(rest);
  return name == "scene" ? UseScene(state, below, arguments) : std::string(kNotFound);
}

std::string SvsPaths::UseScene(StateScene& state, std::string_view rest, Arguments arguments) {
  const std::string_view argument = arguments.empty() ? std::string_view() : std::string_view(arguments[0]);
  const bool help = argument == "help";
  if (IsHere(rest)) return help ? std::string() : ListScene(state.scene(), 0);
  auto [name, below] = SplitPath(rest);
  if (name == "world") {
    const Node* node = &state.scene().root();
    while (!IsHere(below)) {
      const auto [child_name, deeper] = SplitPath(below);
      const auto& children = node->children();
      const auto child = std::find_if(children.begin(), children.end(),
                                      [name = child_name](const auto& candidate) { return candidate->id() == name; });
      if (child == children.end()) return std::string(kNotFound);
      node = child->get();
      below = deeper;
    }
    return UseNode(*node, arguments);
  }
  if (!IsHere(below)) return std::string(kNotFound);
  if (argument == "dir") return {};
  if (name == "properties") return help ? "Get scene properties.\n" : Properties(state.scene());
  if (name == "clear") {
    if (help) return "Delete all objects in scene except world\n";
    imagery_.Clear(state);
    return {};
  }
  if (name == "sgel") {
    if (help) {
      return "Modify scene graph with SGEL.\n\nARGUMENTS\nSGEL - SGEL std::string (spaces are okay). \n";
    }
    std::string line;
    for (const std::string& word : arguments) line += word + " ";
    if (!line.empty()) line.pop_back();
    const std::optional<kernel::imagery::LineError> error = imagery_.Apply(state, line);
    return error ? Fail(error->ToString() + "\n") : std::string();
  }
  if (name == "draw") {
    if (help) {
      return "Draw this scene in the viewer.\n\nARGUMENTS\n"
             "[VALUE] - New value. Must be (0|1|on|off|true|false). \n";
    }
    if (arguments.empty()) return state.drawn() ? "true\n" : "false\n";
    if (argument == "on" || argument == "true" || argument == "1") {
      imagery_.Draw(state, true);
    } else if (argument == "off" || argument == "false" || argument == "0") {
      imagery_.Draw(state, false);
    } else {
      return "invalid boolean\n";
    }
    return {};
  }
  return std::string(kNotFound);
}

std::string SvsPaths::UseNode(const Node& node, Arguments arguments) {
  if (!arguments.empty() && arguments[0] == "help") return "Reports information about this node.\n";
  if (!arguments.empty() && arguments[0] == "dir") return ListBelow(node, 0);
  return TextOfNode(node);
}

std::string SvsPaths::Connect(Arguments arguments) {
  if (arguments.empty()) return "specify socket path\n";
  if (arguments[0] == "help") {
    return "Connects to a viewer that listens, and shows it the scenes that are drawn.\n\nARGUMENTS\n"
           "PORT - A TCP port of this machine, or a socket in the file system. \n";
  }
  std::string why;
  kernel::imagery::ViewerSink sink = ConnectToViewer(arguments[0], why);
  if (!sink) return Fail("connection failed: " + why + "\n");
  imagery_.SetViewer(std::move(sink));
  return "connection successful\n";
}

}  // namespace soarbox::cli
