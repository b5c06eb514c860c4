// SPDX-License-Identifier: BSD-2-Clause
#include "cli/svs_facts.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "kernel/agent.h"
#include "kernel/imagery/imagery.h"

namespace soarbox::cli {
namespace {

using kernel::imagery::Combination;
using kernel::imagery::Content;
using kernel::imagery::Filter;
using kernel::imagery::Inputs;
using kernel::imagery::Node;
using kernel::imagery::NumberText;
using kernel::imagery::SceneCommand;
using kernel::imagery::Shape;
using kernel::imagery::SightLine;
using kernel::imagery::StateScene;
using kernel::imagery::TrackedList;
using ImageryValue = kernel::imagery::Value;
using kernel::imagery::Vec3;

/// Maximum numbers of values of an extract, of lines of each value, and of points of a node; maximum depth of an
/// explanation.
constexpr std::size_t kMostValues = 40, kMostLines = 60, kMostPoints = 200;
constexpr int kDeepest = 6;

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      quoted += ' ';
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

/// Writes JSON, element by element.
class JsonWriter {
 public:
  explicit JsonWriter(std::string& out) : out_(out) {}
  void Begin(char bracket) {
    Comma();
    out_ += bracket;
    first_ = true;
  }
  void End(char bracket) {
    out_ += bracket;
    first_ = false;
  }
  void Name(std::string_view name) {
    Comma();
    out_ += Quoted(name) + ":";
    first_ = true;
  }
  void Raw(std::string_view text) {
    Comma();
    out_ += text;
  }
  void Text(std::string_view name, std::string_view text) {
    Name(name);
    Raw(Quoted(text));
  }
  void Number(double number) { Raw(NumberText(number)); }
  void Vector(const Vec3& vector) {
    for (int axis = 0; axis < 3; ++axis) Number(vector[axis]);
  }
  void Vector(std::string_view name, const Vec3& vector) {
    Name(name);
    Begin('[');
    Vector(vector);
    End(']');
  }

 private:
  void Comma() {
    if (!first_) out_ += ',';
    first_ = false;
  }
  std::string& out_;
  bool first_ = true;
};

std::string FactText(const Content& content) {
  const auto vector = [](const Vec3& at) {
    return "(" + NumberText(at.x) + ", " + NumberText(at.y) + ", " + NumberText(at.z) + ")";
  };
  if (const auto* number = std::get_if<double>(&content)) return NumberText(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&content)) return std::to_string(*integer);
  if (const bool* const answer = std::get_if<bool>(&content)) return *answer ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&content)) return *text;
  if (Node* const* const node = std::get_if<Node*>(&content)) return *node == nullptr ? "" : (*node)->id();
  if (const auto* at = std::get_if<Vec3>(&content)) return vector(*at);
  const auto& box = std::get<kernel::imagery::Box>(content);
  return "from " + vector(box.low) + " to " + vector(box.high);
}

void WriteNode(const Node& node, JsonWriter& out) {
  constexpr std::string_view kShapes[] = {"group", "hull", "ball"};
  out.Begin('{');
  out.Text("parent", node.parent() == nullptr ? "" : node.parent()->id());
  out.Text("shape", kShapes[static_cast<std::size_t>(node.shape())]);
  const kernel::imagery::Transform::Parts parts = node.World().Decompose();
  out.Vector("at", parts.position);
  out.Name("turn");
  out.Begin('[');
  for (const double part : parts.rotation) out.Number(part);
  out.End(']');
  out.Vector("scale", parts.scale);
  if (node.shape() == Shape::kBall) {
    out.Name("radius");
    out.Number(node.radius());
  }
  if (node.shape() == Shape::kHull) {
    out.Name("points");
    out.Begin('[');
    for (std::size_t n = 0; n < std::min(node.points().size(), kMostPoints); ++n) out.Vector(node.points()[n]);
    out.End(']');
  }
  out.Name("tags");
  out.Begin('{');
  for (const auto& [name, value] : node.tags()) out.Text(name, value);
  out.End('}');
  out.End('}');
}

/// The arguments of a filter for one of its values, by name.
struct Given {
  const Node* a = nullptr;
  const Node* b = nullptr;
  const Node* eye = nullptr;
  std::string type, axis;
  bool has_reference = false;
  std::vector<std::string> nodes;
};

Given GivenIn(const Filter& filter, const Combination& combination) {
  Given given;
  const auto& parameters = filter.inputs().parameters();
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    const ImageryValue* const argument = filter.inputs().ArgumentOf(combination, n);
    if (argument == nullptr) continue;
    const Content& content = argument->content;
    const std::string& name = parameters[n].name;
    if (Node* const* const node = std::get_if<Node*>(&content)) {
      if (*node == nullptr) continue;
      given.nodes.push_back((*node)->id());
      if (name == "a" && given.a == nullptr) given.a = *node;
      if (name == "b" && given.b == nullptr) given.b = *node;
      if (name == "eye") given.eye = *node;
      given.has_reference |= name == "reference";
    } else if (const auto* text = std::get_if<std::string>(&content)) {
      if (name.ends_with("_type")) given.type = *text;
      if (name == "axis") given.axis = *text;
    }
  }
  return given;
}

class ExtractWriter {
 public:
  ExtractWriter(const kernel::Agent& agent, const StateScene& state, JsonWriter& out)
      : agent_(agent), state_(state), out_(out) {}

  void Write(std::string_view kind, kernel::WmeId element, const SceneCommand& command) {
    out_.Begin('{');
    out_.Text("command", kind);
    out_.Text("rule", RuleOf(element));
    const kernel::imagery::Trouble trouble = command.trouble();
    if (!trouble.problem.empty()) {
      out_.Text("problem", trouble.problem);
      out_.Text("hint", trouble.hint);
    }
    if (const Filter* const filter = command.filter()) WriteFilter(*filter, command);
    out_.End('}');
  }

 private:
  std::string_view RuleOf(kernel::WmeId element) const {
    if (element == kernel::WmeId::kNone) return {};
    const kernel::PreferenceId maker = agent_.memory().record(element).preference;
    return maker == kernel::PreferenceId::kNone
               ? std::string_view()
               : agent_.ProductionName(agent_.memory().preference(maker).instantiation);
  }

  void WriteFilter(const Filter& filter, const SceneCommand& command) {
    out_.Text("filter", filter.kind() == nullptr ? "" : filter.kind()->name);
    out_.Text("status", filter.status());
    out_.Name("count");
    out_.Raw(std::to_string(filter.output().size()));
    out_.Name("values");
    out_.Begin('[');
    std::size_t count = 0;
    for (const ImageryValue& value : filter.output()) {
      if (++count > kMostValues) break;
      out_.Begin('{');
      if (const kernel::Symbol record = command.RecordOf(value)) {
        const auto& symbols = agent_.symbols();
        out_.Text("record", symbols.Letter(record) + std::to_string(symbols.Number(record)));
      }
      WriteValue(value, filter, 0);
      WriteMarks(value, filter);
      out_.End('}');
    }
    out_.End(']');
  }

  /// Writes the value and its arguments.
  void WriteValue(const ImageryValue& value, const Filter& filter, int depth) {
    out_.Text("value", FactText(value.content));
    if (depth >= kDeepest) return;
    out_.Name("from");
    out_.Begin('[');
    const auto& parameters = filter.inputs().parameters();
    for (std::size_t n = 0; n < parameters.size(); ++n) {
      const Filter& source = *parameters[n].source;
      const ImageryValue* const argument = value.from == nullptr ? nullptr : filter.inputs().ArgumentOf(*value.from, n);
      // A filter without combinations (occlusion) has one value for all arguments.
      if (argument == nullptr && (value.from != nullptr || source.output().size() == 0)) continue;
      out_.Begin('{');
      out_.Text("name", parameters[n].name);
      if (argument != nullptr) {
        if (source.kind() != nullptr) out_.Text("filter", source.kind()->name);
        WriteValue(*argument, source, depth + 1);
      } else {
        out_.Text("value", TextOfAll(source));
      }
      out_.End('}');
    }
    out_.End(']');
  }

  static std::string TextOfAll(const Filter& filter) {
    constexpr std::size_t kMostNamed = 8;
    std::string text;
    std::size_t count = 0;
    for (const ImageryValue& value : filter.output()) {
      if (++count > kMostNamed) return text + ", ...";
      text += (text.empty() ? "" : ", ") + FactText(value.content);
    }
    return text;
  }

  void Line(const SightLine& line, bool hidden) {
    out_.Vector(line.from);
    out_.Vector(line.to);
    out_.Raw(hidden ? "1" : "0");
  }

  /// Writes the lines in the scene that explain the value.
  void WriteMarks(const ImageryValue& value, const Filter& filter) {
    const std::string_view kind = filter.kind() == nullptr ? std::string_view() : filter.kind()->name;
    const auto& combinations = filter.inputs().combinations();
    if (kind == "occlusion") {
      WriteSight(filter, combinations);
      return;
    }
    if (value.from == nullptr) return;
    const Given given = GivenIn(filter, *value.from);
    out_.Name("nodes");
    out_.Begin('[');
    for (const std::string& node : given.nodes) out_.Raw(Quoted(node));
    out_.End(']');
    out_.Name("lines");
    out_.Begin('[');
    const bool two = given.a != nullptr && given.b != nullptr && given.a != given.b;
    if (two && (kind.starts_with("distance") || kind == "closest" || kind == "farthest")) {
      Line(given.type == "hull" ? kernel::imagery::ShortestLine(*given.a, *given.b)
                                : SightLine{given.a->World().shift(), given.b->World().shift()},
           false);
    } else if (two && kind.starts_with("axis_") && !given.axis.empty() && !given.has_reference) {
      const int letter = given.axis[0] | 0x20;
      WriteAxis(*given.a, *given.b, letter == 'y' ? 1 : letter == 'z' ? 2 : 0);
    } else if (kind == "monitor_position" && given.a != nullptr) {
      Line({given.a->World().shift(), given.a->World().shift()}, false);
    }
    if (const auto* place = std::get_if<Vec3>(&value.content); place != nullptr && kind == "calculate_placement")
      Line({given.b != nullptr ? given.b->Centroid() : *place, *place}, false);
    out_.End(']');
  }

  /// Writes a line along the axis between the facing sides of two nodes; none if they overlap.
  void WriteAxis(const Node& a, const Node& b, int axis) {
    SightLine line{a.Centroid(), a.Centroid()};
    const auto &of_a = a.Bounds(), &of_b = b.Bounds();
    const bool above = of_b.low[axis] > of_a.high[axis];
    if (!above && of_b.high[axis] >= of_a.low[axis]) return;
    line.from[axis] = above ? of_a.high[axis] : of_a.low[axis];
    line.to[axis] = above ? of_b.low[axis] : of_b.high[axis];
    Line(line, false);
  }

  void WriteSight(const Filter& filter, const TrackedList<Combination>& combinations) {
    std::vector<std::pair<const Node*, const Node*>> seen;
    std::vector<const Node*> occluders;
    for (const Combination& combination : combinations) {
      const Given given = GivenIn(filter, combination);
      const Node* const eye = given.eye != nullptr ? given.eye : state_.scene().Find("eye");
      if (given.a == nullptr || given.b == nullptr || eye == nullptr) continue;
      if (std::ranges::find(seen, std::pair(given.a, eye)) == seen.end()) seen.emplace_back(given.a, eye);
      if (std::ranges::find(occluders, given.b) == occluders.end()) occluders.push_back(given.b);
    }
    std::vector<SightLine> lines;
    for (const auto& [target, eye] : seen) kernel::imagery::AppendSightLines(*target, *eye, lines);
    if (lines.size() > kMostLines) lines.resize(kMostLines);
    out_.Name("lines");
    out_.Begin('[');
    for (const SightLine& line : lines) Line(line, kernel::imagery::Occlusion({&line, 1}, occluders) > 0);
    out_.End(']');
  }

  const kernel::Agent& agent_;
  const StateScene& state_;
  JsonWriter& out_;
};

}  // namespace

std::string SceneFactsText(const kernel::Agent& agent, std::string_view known) {
  const kernel::Imagery* const imagery = agent.find_imagery();
  if (imagery == nullptr || !imagery->enabled()) return "version 0\n";
  // 0 means that the client has no version yet.
  const std::string version = std::to_string(imagery->version() + 1);
  std::string text = "version " + version + "\n";
  if (known == version) return text;
  for (const auto& state : imagery->states()) {
    const std::string& name = state->scene().name();
    state->scene().ForEach([&](const Node& node) {
      text += name + " node " + Quoted(node.id()) + " ";
      JsonWriter out(text);
      WriteNode(node, out);
      text += '\n';
    });
    state->ForEachCommand(
        [&](std::string_view kind, const std::string& id, kernel::WmeId element, const SceneCommand& command) {
          text += name + " extract " + Quoted(id) + " ";
          JsonWriter out(text);
          ExtractWriter(agent, *state, out).Write(kind, element, command);
          text += '\n';
        });
  }
  return text;
}

}  // namespace soarbox::cli
