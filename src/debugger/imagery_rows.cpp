// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/imagery_rows.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "debugger/facts_text.h"
#include "debugger/fields.h"
#include "debugger/why.h"
#include "explain/scene_source.h"

namespace soarbox::debugger {
namespace {

using explain::WhyNode;

std::string TextIn(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

template <std::size_t size>
void Read(const Json& json, const char* name, std::array<double, size>& numbers) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_array() || found->size() != size) return;
  for (std::size_t n = 0; n < size; ++n) {
    if ((*found)[n].is_number()) numbers[n] = (*found)[n].template get<double>();
  }
}

std::vector<double> NumbersIn(const Json& json, const char* name) {
  std::vector<double> numbers;
  const auto found = json.find(name);
  if (found == json.end() || !found->is_array()) return numbers;
  for (const Json& number : *found) numbers.push_back(number.is_number() ? number.get<double>() : 0);
  return numbers;
}

/// The input of the filter that computed a value: "^a self ^b box-1".
std::string GivenTo(const Json& value) {
  const auto from = value.find("from");
  std::string given;
  if (from == value.end() || !from->is_array()) return given;
  for (const Json& argument : *from)
    if (argument.is_object())
      given += (given.empty() ? "^" : " ^") + TextIn(argument, "name") + " " + TextIn(argument, "value");
  return given;
}

/// Explains a value by what it was computed from: "hull distance from self to box-1: 1.4".
WhyNode WhyOf(const Json& value, const std::string& filter, const std::string& begin) {
  WhyNode node;
  node.kind = WhyKind::kImagined;
  node.link = TextIn(value, "record");
  const std::string text = TextIn(value, "value");
  node.text = begin + text;
  if (filter.empty()) return node;
  const std::string given = GivenTo(value);
  node.text += ": " + filter + (given.empty() ? "" : " " + given);
  const auto from = value.find("from");
  if (from == value.end() || !from->is_array()) return node;
  for (const Json& argument : *from) {
    if (!argument.is_object()) continue;
    const std::string source = TextIn(argument, "filter");
    // A value that was given by name needs no explanation.
    if (source.empty() || source == "node" || source == "all_nodes") continue;
    node.below.push_back(WhyOf(argument, source, "^" + TextIn(argument, "name") + " is "));
  }
  return node;
}

SceneNodeRow ReadNode(std::string name, const Json& json) {
  SceneNodeRow node;
  node.name = std::move(name);
  node.parent = TextIn(json, "parent");
  node.shape = TextIn(json, "shape");
  Read(json, "at", node.at);
  Read(json, "turn", node.turn);
  Read(json, "scale", node.scale);
  if (const auto radius = json.find("radius"); radius != json.end() && radius->is_number())
    node.radius = radius->get<double>();
  const std::vector<double> points = NumbersIn(json, "points");
  for (std::size_t n = 0; n + 2 < points.size(); n += 3)
    node.points.push_back({points[n], points[n + 1], points[n + 2]});
  if (const auto tags = json.find("tags"); tags != json.end() && tags->is_object()) {
    for (const auto& [tag, value] : tags->items()) {
      if (value.is_string()) node.tags[tag] = value.get<std::string>();
    }
  }
  return node;
}

SceneExtractRow ReadExtract(std::string id, const Json& json) {
  SceneExtractRow extract;
  extract.id = std::move(id);
  extract.command = TextIn(json, "command");
  extract.rule = TextIn(json, "rule");
  extract.filter = TextIn(json, "filter");
  extract.status = TextIn(json, "status");
  extract.problem = TextIn(json, "problem");
  extract.hint = TextIn(json, "hint");
  if (const auto count = json.find("count"); count != json.end() && count->is_number_unsigned())
    extract.count = count->get<std::size_t>();
  const auto values = json.find("values");
  if (values == json.end() || !values->is_array()) return extract;
  for (const Json& value : *values) {
    if (!value.is_object()) continue;
    SceneValueRow& row = extract.values.emplace_back();
    row.record = TextIn(value, "record");
    row.text = TextIn(value, "value");
    row.why = WhyOf(value, extract.filter, {});
    if (!extract.filter.empty()) row.given = GivenTo(value);
    if (const auto nodes = value.find("nodes"); nodes != value.end() && nodes->is_array()) {
      for (const Json& node : *nodes) {
        if (node.is_string()) row.nodes.push_back(node.get<std::string>());
      }
    }
    const std::vector<double> lines = NumbersIn(value, "lines");
    for (std::size_t n = 0; n + 6 < lines.size(); n += 7) {
      row.lines.push_back(
          {{lines[n], lines[n + 1], lines[n + 2]}, {lines[n + 3], lines[n + 4], lines[n + 5]}, lines[n + 6] > 0});
    }
  }
  return extract;
}

/// Sorts nodes so that each comes before its children. Siblings keep their order.
void Order(SceneView& scene) {
  std::multimap<std::string, std::size_t> by_parent;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) by_parent.emplace(scene.nodes[n].parent, n);
  std::vector<SceneNodeRow> ordered;
  std::vector<std::pair<std::size_t, int>> waiting;
  const auto add_children = [&](const std::string& parent, int depth) {
    const auto [begin, end] = by_parent.equal_range(parent);
    const std::size_t first = waiting.size();
    for (auto at = begin; at != end; ++at) waiting.emplace_back(at->second, depth);
    std::reverse(waiting.begin() + static_cast<long>(first), waiting.end());
  };
  add_children({}, 0);
  while (!waiting.empty() && ordered.size() < scene.nodes.size()) {
    const std::pair<std::size_t, int> next = waiting.back();
    waiting.pop_back();
    SceneNodeRow& node = scene.nodes[next.first];
    node.depth = next.second;
    ordered.push_back(node);
    add_children(node.name, next.second + 1);
  }
  scene.nodes = std::move(ordered);
}

std::string PlaceText(const ScenePoint& at) {
  const auto number = [](double value) {
    std::string text = std::to_string(value);
    return text.substr(0, text.find('.') + 3);
  };
  return "(" + number(at[0]) + ", " + number(at[1]) + ", " + number(at[2]) + ")";
}

/// A line of the output of `svs facts`: STATE node "NAME" {...}
struct FactLine {
  std::string state, kind, name;
  Json object;
};

/// Removes lines from the text up to the first valid one that contains `part`, and returns that line.
std::optional<FactLine> NextFact(std::string_view& facts, std::string_view part = {}) {
  while (!facts.empty()) {
    const std::size_t end = std::min(facts.find('\n'), facts.size());
    const std::string_view line = facts.substr(0, end);
    facts.remove_prefix(std::min(end + 1, facts.size()));
    if (line.find(part) == std::string_view::npos) continue;
    const std::size_t kind_at = line.find(' '), name_at = line.find(" \""), object_at = line.find("\" {");
    if (kind_at == std::string_view::npos || name_at == std::string_view::npos || object_at == std::string_view::npos ||
        name_at <= kind_at || object_at < name_at + 2)
      continue;
    const Json name = Json::parse(line.substr(name_at + 1, object_at - name_at), nullptr, false);
    FactLine fact{std::string(line.substr(0, kind_at)),
                  std::string(line.substr(kind_at + 1, name_at - kind_at - 1)),
                  {},
                  Json::parse(line.substr(object_at + 2), nullptr, false)};
    if (!name.is_string() || !fact.object.is_object()) continue;
    fact.name = name.get<std::string>();
    return fact;
  }
  return std::nullopt;
}

}  // namespace

ImageryView ReadImagery(std::string_view facts) {
  ImageryView view;
  while (const std::optional<FactLine> line = NextFact(facts)) {
    if (view.scenes.empty() || view.scenes.back().state != line->state) view.scenes.emplace_back().state = line->state;
    SceneView& scene = view.scenes.back();
    if (line->kind == "node") scene.nodes.push_back(ReadNode(line->name, line->object));
    if (line->kind == "extract") scene.extracts.push_back(ReadExtract(line->name, line->object));
  }
  for (SceneView& scene : view.scenes) Order(scene);
  if (view.scenes.empty())
    view.note =
        "It imagines nothing. Give it senses = { scene = true } in the scenario, or write svs --enable in its rules.";
  return view;
}

ImageryView LookAtImagery(explain::Inspector& mind) {
  auto* const source = dynamic_cast<explain::SceneSource*>(&mind);
  if (source == nullptr) {
    ImageryView view;
    view.note = "What it imagined is not recorded. Soarbox can show it once it has simulated this moment again.";
    return view;
  }
  return ReadImagery(source->SceneFacts());
}

std::optional<WhyNode> WhyRecord(explain::Inspector& mind, std::string_view record) {
  auto* const source = dynamic_cast<explain::SceneSource*>(&mind);
  if (source == nullptr) return std::nullopt;
  const std::string all = source->SceneFacts(), with_record = "\"record\":\"" + std::string(record) + "\"";
  std::string_view facts = all;
  // Parses only lines that contain the name of the record.
  while (const std::optional<FactLine> line = NextFact(facts, with_record)) {
    const SceneExtractRow extract = ReadExtract(line->name, line->object);
    for (const SceneValueRow& value : extract.values) {
      if (value.record != record) continue;
      WhyNode why = value.why;
      why.text = "imagined by " + extract.command + " " + extract.id + " in " + line->state + ": " + why.text;
      if (!extract.rule.empty()) why.below.push_back({"asked by rule " + extract.rule, WhyKind::kRule, extract.rule});
      return why;
    }
  }
  return std::nullopt;
}

std::string ToText(const ImageryView& view) {
  if (!view.note.empty()) return view.note + "\n";
  std::string text;
  for (const SceneView& scene : view.scenes) {
    text += scene.state + "\n";
    for (const SceneNodeRow& node : scene.nodes) {
      text += std::string(static_cast<std::size_t>(node.depth) * 2 + 2, ' ') + node.name;
      if (node.depth > 0) text += "  " + node.shape + " at " + PlaceText(node.at);
      for (const auto& [name, value] : node.tags) text += " ^" + name + " " + value;
      text += "\n";
    }
    for (const SceneExtractRow& extract : scene.extracts) {
      text += "  " + extract.command + " " + extract.id + (extract.filter.empty() ? "" : " " + extract.filter);
      if (!extract.rule.empty()) text += " (rule " + extract.rule + ")";
      if (!extract.problem.empty()) text += ": " + extract.problem + "; " + extract.hint;
      text += "\n";
      for (const SceneValueRow& value : extract.values) {
        for (const std::string& line : explain::Lines(value.why, 2)) text += line + "\n";
      }
      if (extract.count > extract.values.size())
        text += "    and " + std::to_string(extract.count - extract.values.size()) + " more\n";
    }
  }
  return text;
}

}  // namespace soarbox::debugger
