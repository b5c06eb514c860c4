// SPDX-License-Identifier: BSD-2-Clause
#include "language/datamap.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "diagnostics/number_from_chars.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::language {
namespace {

using Kind = Datamap::Kind;
using Objects = std::set<std::size_t>;

std::vector<std::string> StepsOf(std::string_view path) {
  std::vector<std::string> steps;
  while (!path.empty()) {
    const std::size_t dot = std::min(path.find('.'), path.size());
    steps.emplace_back(path.substr(0, dot));
    path.remove_prefix(std::min(dot + 1, path.size()));
  }
  return steps;
}

bool IsState(const Datamap& datamap, std::size_t vertex) {
  return vertex == datamap.root || std::ranges::any_of(datamap.vertices[vertex].edges, [](const Datamap::Edge& edge) {
           return edge.attribute == "superstate";
         });
}

Objects States(const Datamap& datamap) {
  Objects states;
  for (std::size_t i = 0; i < datamap.vertices.size(); ++i)
    if (IsState(datamap, i)) states.insert(i);
  return states;
}

/// The objects to which an attribute leads; * matches any attribute.
Objects Follow(const Datamap& datamap, const Objects& from, const std::string& attribute) {
  Objects reached;
  for (const std::size_t at : from)
    for (const Datamap::Edge& edge : datamap.vertices[at].edges)
      if (attribute == "*" || edge.attribute == attribute) reached.insert(edge.to);
  return reached;
}

std::string NearestOf(const std::string& word, const std::set<std::string>& known) {
  const std::string_view near = Suggest(word, {known.begin(), known.end()});
  if (!near.empty()) return "did you mean " + std::string(near) + "?";
  std::string all;
  for (const std::string& one : known) {
    if (all.size() > 100) {
      all += " ...";
      break;
    }
    all += " " + one;
  }
  return all.empty() ? "add it to the datamap" : "the datamap has:" + all;
}

bool IsNumber(const std::string& text, double& number) {
  const auto [end, error] = NumberFromChars(text, number);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Whether one of the vertices permits this value.
bool MayBe(const Datamap& datamap, const Objects& values, const std::string& word) {
  return std::ranges::any_of(values, [&](std::size_t at) {
    const Datamap::Vertex& vertex = datamap.vertices[at];
    double number = 0;
    switch (vertex.kind) {
      case Kind::kString:
        return true;
      // The kernel's own checks report a constant instead of an object.
      case Kind::kObject:
        return true;
      case Kind::kEnumeration:
        return std::ranges::find(vertex.words, word) != vertex.words.end();
      case Kind::kInteger:
      case Kind::kFloat:
        return IsNumber(word, number) &&
               ((vertex.min == 0 && vertex.max == 0) || (number >= vertex.min && number <= vertex.max));
    }
    return true;
  });
}

std::set<std::string> WordsOf(const Datamap& datamap, const Objects& values) {
  std::set<std::string> words;
  for (const std::size_t at : values) {
    const Datamap::Vertex& vertex = datamap.vertices[at];
    words.insert(vertex.words.begin(), vertex.words.end());
  }
  return words;
}

Diagnostic WarningAt(const Document& document, std::size_t offset, std::size_t length, std::string message,
                     std::string hint) {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.file = document.path().string();
  const std::size_t line = document.lines().LineOf(offset);
  warning.line = static_cast<int>(line) + 1;
  warning.column = static_cast<int>(offset - document.lines().Begin(line)) + 1;
  warning.excerpt = document.lines().Line(line);
  warning.excerpt_length = static_cast<int>(std::max<std::size_t>(length, 1));
  warning.message = std::move(message);
  warning.hint = std::move(hint);
  return warning;
}

void AddWord(Datamap& datamap, std::size_t object, const std::string& attribute, const std::string& word) {
  double number = 0;
  const Kind kind = !IsNumber(word, number)                          ? Kind::kEnumeration
                    : word.find_first_of(".eE") != std::string::npos ? Kind::kFloat
                                                                     : Kind::kInteger;
  for (const Datamap::Edge& edge : datamap.vertices[object].edges) {
    if (edge.attribute != attribute) continue;
    Datamap::Vertex& vertex = datamap.vertices[edge.to];
    if (vertex.kind == Kind::kString || (vertex.kind == Kind::kFloat && kind == Kind::kInteger)) return;
    if (vertex.kind != kind) continue;
    if (kind == Kind::kEnumeration && std::ranges::find(vertex.words, word) == vertex.words.end())
      vertex.words.push_back(word);
    return;
  }
  const std::size_t made = datamap.Add(kind);
  if (kind == Kind::kEnumeration) datamap.vertices[made].words.push_back(word);
  datamap.vertices[object].edges.push_back({attribute, made});
}

std::size_t AddTyped(Datamap& datamap, vocabulary::ValueType type, double min, double max, std::string_view words) {
  using vocabulary::ValueType;
  const Kind kind = type == ValueType::kObject                   ? Kind::kObject
                    : type == ValueType::kInteger                ? Kind::kInteger
                    : type == ValueType::kWord && !words.empty() ? Kind::kEnumeration
                    : type == ValueType::kWord                   ? Kind::kString
                                                                 : Kind::kFloat;
  const std::size_t made = datamap.Add(kind);
  Datamap::Vertex& vertex = datamap.vertices[made];
  vertex.min = min;
  vertex.max = max;
  while (!words.empty()) {
    const std::size_t blank = std::min(words.find(' '), words.size());
    if (blank > 0) vertex.words.emplace_back(words.substr(0, blank));
    words.remove_prefix(std::min(blank + 1, words.size()));
  }
  return made;
}

void AddVocabulary(Datamap& datamap) {
  const std::size_t io = datamap.ObjectAt(datamap.root, "io");
  const std::size_t input = datamap.ObjectAt(io, "input-link"), output = datamap.ObjectAt(io, "output-link");
  for (const vocabulary::PerceptRow& row : vocabulary::Percepts()) {
    std::size_t object = input;
    std::vector<std::string> steps = StepsOf(row.path);
    const std::string last = steps.back();
    steps.pop_back();
    for (const std::string& step : steps) object = datamap.ObjectAt(object, step);
    if (row.type == vocabulary::ValueType::kObject) {
      datamap.ObjectAt(object, last);
    } else {
      const std::size_t made = AddTyped(datamap, row.type, row.min, row.max, row.words);
      datamap.vertices[object].edges.push_back({last, made});
    }
  }
  for (const vocabulary::CommandRow& row : vocabulary::Commands()) {
    const std::size_t command = datamap.ObjectAt(output, row.name);
    const auto add = [&](const vocabulary::ParameterRow& parameter) {
      const std::size_t made = AddTyped(datamap, parameter.type, parameter.min, parameter.max, parameter.words);
      datamap.vertices[command].edges.push_back({std::string(parameter.name), made});
    };
    for (const vocabulary::ParameterRow& parameter : row.parameters) add(parameter);
    if (row.place != vocabulary::TakesPlace::kNo)
      for (const vocabulary::ParameterRow& parameter : vocabulary::PlaceParameters()) add(parameter);
    for (const char* word : {"complete", "error", "interrupted"}) AddWord(datamap, command, "status", word);
  }
}

}  // namespace

std::size_t Datamap::ObjectAt(std::size_t object, std::string_view attribute) {
  for (const Edge& edge : vertices[object].edges)
    if (edge.attribute == attribute && vertices[edge.to].kind == Kind::kObject) return edge.to;
  const std::size_t made = Add(Kind::kObject);
  vertices[object].edges.push_back({std::string(attribute), made});
  return made;
}

std::vector<Diagnostic> FindUnknown(const Datamap& datamap, const Document& document) {
  std::vector<Diagnostic> warnings;
  if (datamap.vertices.empty()) return warnings;
  const Objects states = States(datamap);
  for (const DocumentRule& rule : document.rules()) {
    for (const Word& word : rule.words->words) {
      if (word.kind != WordKind::kAttribute && word.kind != WordKind::kValue) continue;
      if (word.path.starts_with('<') || word.path.empty()) continue;
      std::vector<std::string> steps = StepsOf(word.path);
      const bool is_value = word.kind == WordKind::kValue;
      if (!is_value) steps.pop_back();
      Objects reached = states;
      for (const std::string& step : steps) {
        // The superstate may be any state.
        reached = step == "superstate" ? states : Follow(datamap, reached, step);
        if (reached.empty()) break;
      }
      if (reached.empty()) continue;  // The attribute before it is the unknown one.
      const std::size_t offset = rule.span.begin + word.span.begin, length = word.span.end - word.span.begin;
      if (is_value) {
        if (MayBe(datamap, reached, word.text)) continue;
        warnings.push_back(WarningAt(document, offset, length,
                                     "the datamap has no value " + word.text + " for ^" + steps.back(),
                                     NearestOf(word.text, WordsOf(datamap, reached))));
        continue;
      }
      if (!Follow(datamap, reached, word.text).empty()) continue;
      std::set<std::string> known;
      bool is_open = false;
      for (const std::size_t at : reached) {
        is_open |= datamap.vertices[at].kind != Kind::kObject;
        for (const Datamap::Edge& edge : datamap.vertices[at].edges) known.insert(edge.attribute);
      }
      if (is_open && known.empty()) continue;
      std::string where;
      for (const std::string& step : steps) where += (where.empty() ? " of ^" : ".") + step;
      warnings.push_back(
          WarningAt(document, offset, length,
                    "the datamap has no attribute ^" + word.text + (where.empty() ? " of states" : where),
                    NearestOf(word.text, known)));
    }
  }
  return warnings;
}

Datamap DatamapOf(const std::vector<const Document*>& documents) {
  Datamap datamap;
  datamap.root = datamap.Add(Kind::kObject);
  AddWord(datamap, datamap.root, "superstate", "nil");
  AddWord(datamap, datamap.root, "type", "state");
  AddVocabulary(datamap);
  for (const Document* document : documents) {
    for (const DocumentRule& rule : document->rules()) {
      for (const Word& word : rule.words->words) {
        if (word.path.starts_with('<') || word.path.empty()) continue;
        std::vector<std::string> steps = StepsOf(word.path);
        // All states are treated as one: the contents of a superstate are those of its substates.
        while (!steps.empty() && steps.front() == "superstate") steps.erase(steps.begin());
        if (steps.empty() || std::ranges::find(steps, "*") != steps.end()) continue;
        const std::string last = steps.back();
        steps.pop_back();
        std::size_t object = datamap.root;
        for (const std::string& step : steps) object = datamap.ObjectAt(object, step);
        if (word.kind == WordKind::kValue) {
          AddWord(datamap, object, last, word.text);
        } else if (word.kind == WordKind::kAttribute &&
                   std::ranges::none_of(datamap.vertices[object].edges,
                                        [&](const Datamap::Edge& edge) { return edge.attribute == last; })) {
          // It is an object if the path continues; until then it may be anything.
          const bool leads_on = std::ranges::any_of(rule.words->words, [&](const Word& other) {
            return other.kind == WordKind::kAttribute && other.path.starts_with(word.path + ".");
          });
          const std::size_t made = datamap.Add(leads_on ? Kind::kObject : Kind::kString);
          datamap.vertices[object].edges.push_back({last, made});
        }
      }
    }
  }
  return datamap;
}

std::string ToProjectJson(const Datamap& datamap, const std::string& name, const std::vector<std::string>& layout) {
  using Json = nlohmann::ordered_json;
  const auto id = [](std::size_t at) { return "v" + std::to_string(at); };
  Json vertices = Json::array();
  for (std::size_t i = 0; i < datamap.vertices.size(); ++i) {
    const Datamap::Vertex& vertex = datamap.vertices[i];
    Json one = {{"id", id(i)}};
    const bool bounded = vertex.min != 0 || vertex.max != 0;
    switch (vertex.kind) {
      case Kind::kObject: {
        one["type"] = "SOAR_ID";
        one["outEdges"] = Json::array();
        for (const Datamap::Edge& edge : vertex.edges)
          one["outEdges"].push_back({{"name", edge.attribute}, {"toId", id(edge.to)}});
        break;
      }
      case Kind::kEnumeration:
        one["type"] = "ENUMERATION";
        one["choices"] = vertex.words;
        break;
      case Kind::kInteger:
        one["type"] = "INTEGER";
        if (bounded)
          one["min"] = static_cast<std::int64_t>(vertex.min), one["max"] = static_cast<std::int64_t>(vertex.max);
        break;
      case Kind::kFloat:
        one["type"] = "FLOAT";
        if (bounded) one["min"] = vertex.min, one["max"] = vertex.max;
        break;
      case Kind::kString:
        one["type"] = "STRING";
        break;
    }
    vertices.push_back(std::move(one));
  }
  Json children = Json::array();
  for (std::size_t i = 0; i < layout.size(); ++i)
    children.push_back({{"type", "FILE_OPERATOR"},
                        {"id", "f" + std::to_string(i)},
                        {"name", std::filesystem::path(layout[i]).stem().string()},
                        {"file", layout[i]}});
  const Json project = {{"version", "6"},
                        {"datamap", {{"rootId", id(datamap.root)}, {"vertices", std::move(vertices)}}},
                        {"layout",
                         {{"type", "OPERATOR_ROOT"},
                          {"id", "root"},
                          {"name", name},
                          {"folder", "."},
                          {"children", std::move(children)}}}};
  return project.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace soarbox::language
