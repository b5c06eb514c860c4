// SPDX-License-Identifier: BSD-2-Clause
#include "sim/agent_options.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "diagnostics/problem.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::sim {
namespace {

using Value = std::variant<bool, double, std::string>;

struct NumberProperty {
  std::string_view name;
  float& (*get)(BodyKind&);
  double min, max;
};

constexpr NumberProperty kNumbers[] = {
    {"height", [](BodyKind& b) -> float& { return b.height_m; }, 0.2, 10},
    {"radius", [](BodyKind& b) -> float& { return b.radius_m; }, 0.05, 5},
    {"mass", [](BodyKind& b) -> float& { return b.mass_kg; }, 1, 10000},
    {"speed", [](BodyKind& b) -> float& { return b.max_speed_mps; }, 0, 50},
    {"walk", [](BodyKind& b) -> float& { return b.walk_mps; }, 0, 50},
    {"force", [](BodyKind& b) -> float& { return b.max_force_n; }, 0, 1e6},
    {"health", [](BodyKind& b) -> float& { return b.health; }, 1, 1000},
    {"senses.sight", [](BodyKind& b) -> float& { return b.senses.sight_m; }, 0, 1000},
    {"senses.view", [](BodyKind& b) -> float& { return b.senses.view_deg; }, 0, 360},
    {"senses.hearing", [](BodyKind& b) -> float& { return b.senses.hearing_m; }, 0, 1000},
    {"senses.memory", [](BodyKind& b) -> float& { return b.senses.memory_s; }, 0, 3600},
    {"senses.noise", [](BodyKind& b) -> float& { return b.senses.noise_m; }, 0, 100},
    {"senses.rate", [](BodyKind& b) -> float& { return b.senses.rate_hz; }, 0.1, 30},
    {"senses.most", [](BodyKind& b) -> float& { return b.senses.most; }, 0, 1000},
    {"weapon.range", [](BodyKind& b) -> float& { return b.weapon.range_m; }, 1, 1000},
    {"weapon.damage", [](BodyKind& b) -> float& { return b.weapon.damage; }, 0, 1000},
    {"weapon.spread", [](BodyKind& b) -> float& { return b.weapon.spread_deg; }, 0, 45},
    {"weapon.interval", [](BodyKind& b) -> float& { return b.weapon.interval_s; }, 0.03, 60},
    {"weapon.reload", [](BodyKind& b) -> float& { return b.weapon.reload_s; }, 0, 60},
};
constexpr std::string_view kOthers[] = {
    "body",           "team",       "leader",       "name",
    "position.x",     "position.y", "position.z",   "position.1",
    "position.2",     "position.3", "heading",      "senses.only",
    "material",       "looks",      "armed",        "weapon.magazine",
    "weapon.reserve", "by",         "senses.scene",
};

Diagnostic Bad(std::string message, std::string hint = {}) {
  return NewProblem(std::move(message), std::move(hint));
}

Diagnostic UnknownOption(const std::string& name) {
  constexpr std::pair<std::string_view, std::string_view> kOtherWords[] = {
      {"kind", "body"},      {"type", "body"},         {"class", "body"},   {"model", "body"},
      {"file", "rules"},     {"soar", "rules"},        {"mind", "rules"},   {"pos", "position"},
      {"place", "position"}, {"location", "position"}, {"number", "count"}, {"color", "material"},
  };
  std::vector<std::string_view> names(std::begin(kOthers), std::end(kOthers));
  for (const NumberProperty& number : kNumbers) names.push_back(number.name);
  names.insert(names.end(), {"rules", "count", "across"});
  std::string_view near = Suggest(name, names);
  for (const auto& [word, meant] : kOtherWords)
    if (name == word) near = meant;
  if (near.starts_with("position")) near = "position";
  if (IsOfWholeScenario(name)) return Bad("no agent has an option '" + name + "'", kOnTop);
  return Bad("no agent has an option '" + name + "'",
             near.empty() ? "docs/scenarios.md lists the options" : "did you mean '" + std::string(near) + "'?");
}

Diagnostic WrongType(const std::string& name, std::string_view wanted) {
  return Bad("the option '" + name + "' takes " + std::string(wanted));
}

std::string Short(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

Result<bool> SetBodyProperty(BodyKind& body, const std::string& name, const Value& value) {
  for (const NumberProperty& property : kNumbers) {
    if (property.name != name) continue;
    const double* number = std::get_if<double>(&value);
    if (number == nullptr) return WrongType(name, "a number");
    if (!(*number >= property.min && *number <= property.max)) {
      return Bad("the option '" + name + "' is " + Short(*number) + ": it takes " + Short(property.min) + " to " +
                 Short(property.max));
    }
    property.get(body) = static_cast<float>(*number);
    if (name == "speed") body.walk_mps = std::min(body.walk_mps, body.max_speed_mps);
    return true;
  }
  if (name == "weapon.magazine" || name == "weapon.reserve") {
    const double* number = std::get_if<double>(&value);
    if (number == nullptr || !(*number >= 0 && *number <= 10000)) return WrongType(name, "a number from 0 to 10000");
    (name == "weapon.magazine" ? body.weapon.magazine : body.weapon.reserve) = static_cast<int>(*number);
    return true;
  }
  if (name == "armed" || name == "senses.scene") {
    const bool* truth = std::get_if<bool>(&value);
    if (truth == nullptr) return WrongType(name, "true or false");
    (name == "armed" ? body.armed : body.senses.scene) = *truth;
    return true;
  }
  if (name == "looks") {
    const std::string* text = std::get_if<std::string>(&value);
    if (text != nullptr && (text->ends_with(".glb") || text->ends_with(".gltf"))) {
      return Bad("the option 'looks' names the model " + *text + ", but only scripts attach models from files",
                 "write looks = \"capsule\" and Core.CreateMesh(agent, \"" + *text + "\") in a script of the world");
    }
    if (text == nullptr || std::find(std::begin(kLooks), std::end(kLooks), *text) == std::end(kLooks)) {
      std::string known;
      for (const std::string_view looks : kLooks) known += (known.empty() ? "\"" : ", \"") + std::string(looks) + "\"";
      return WrongType(name, "one of " + known);
    }
    body.looks = *text;
    return true;
  }
  if (name == "material") {
    const std::string* text = std::get_if<std::string>(&value);
    if (text == nullptr) return WrongType(name, "a name");
    body.material = *text;
    return true;
  }
  if (name.starts_with("senses.only.")) {
    const std::string* text = std::get_if<std::string>(&value);
    if (text == nullptr) return WrongType("senses.only", "a list of names of senses");
    if (vocabulary::FindSense(*text) == nullptr) {
      std::vector<std::string_view> names;
      for (const vocabulary::SenseRow& row : vocabulary::Senses()) names.push_back(row.name);
      const std::string_view near = Suggest(*text, names);
      return Bad("there is no sense '" + *text + "'",
                 near.empty() ? "docs/percepts.md lists the senses" : "did you mean '" + std::string(near) + "'?");
    }
    body.senses.only.insert(*text);
    return true;
  }
  return false;
}

namespace {

/// Sets the body from the name of its kind.
std::optional<Diagnostic> ChooseBody(const Value& given, const std::vector<BodyKind>& kinds, BodyKind& body) {
  const std::string* name = std::get_if<std::string>(&given);
  if (name == nullptr) return WrongType("body", "the name of a body");
  const auto at = std::find_if(kinds.begin(), kinds.end(), [&](const BodyKind& kind) { return kind.name == *name; });
  if (at != kinds.end()) {
    body = *at;
    return std::nullopt;
  }
  std::vector<std::string_view> names;
  std::string all = "there are:";
  for (const BodyKind& kind : kinds) {
    names.push_back(kind.name);
    all += " " + kind.name;
  }
  const std::string_view near = Suggest(*name, names);
  return Bad("there is no body '" + *name + "'", near.empty() ? all : "did you mean '" + std::string(near) + "'?");
}

bool IsCoordinate(const std::string& name) {
  return name.starts_with("position.") && name.size() == 10 &&
         std::string_view("xyz123").find(name[9]) != std::string_view::npos;
}

/// Sets any option except coordinates and the kind of body.
std::optional<Diagnostic> SetOption(const std::string& name, const Value& value, AgentOptions& read) {
  const std::string* text = std::get_if<std::string>(&value);
  if (name == "name" || name == "team" || name == "leader") {
    if (text == nullptr) return WrongType(name, "a name");
    if (name == "team") read.team = *text;
    if (name == "leader") read.leader = *text;
    return std::nullopt;
  }
  if (name == "by") {
    if (text == nullptr || *text != "sandbox")
      return WrongType(name, "\"sandbox\": the script of the world gives it percepts and carries out its commands");
    read.by_sandbox = true;
    return std::nullopt;
  }
  if (name == "position") return WrongType(name, "two numbers: [x, z]");
  if (name == "heading") {
    const double* number = std::get_if<double>(&value);
    if (number == nullptr || !std::isfinite(*number)) return WrongType(name, "degrees");
    read.heading_deg = static_cast<float>(*number);
    return std::nullopt;
  }
  const Result<bool> set = SetBodyProperty(read.body, name, value);
  if (!set) return set.error();
  if (!set.value()) return UnknownOption(name);
  return std::nullopt;
}

}  // namespace

AgentOptions ReadAgentOptions(const Options& options, const std::vector<BodyKind>& kinds,
                              std::vector<OptionProblem>& problems) {
  AgentOptions read;
  read.body = kinds.front();
  const auto note = [&problems](const std::string& name, std::optional<Diagnostic> problem) {
    if (problem) problems.push_back({name, std::move(*problem)});
  };
  // The kind comes first, because other options change it.
  if (const auto given = options.find("body"); given != options.end())
    note("body", ChooseBody(given->second, kinds, read.body));
  std::optional<double> x, z;
  bool bad_position = false;
  for (const auto& [name, value] : options) {
    if (name.starts_with("senses.")) read.has_senses = true;
    if (name == "body") continue;
    if (!IsCoordinate(name)) {
      note(name, SetOption(name, value, read));
      continue;
    }
    const double* number = std::get_if<double>(&value);
    if (number == nullptr || !std::isfinite(*number)) {
      if (!bad_position) note("position", WrongType("position", "numbers: [x, z]"));
      bad_position = true;
      continue;
    }
    // [x, z], [x, y, z] or a vector. The ground determines the height.
    const bool has_three = options.contains("position.3");
    if (name[9] == 'x' || name[9] == '1') x = *number;
    if (name[9] == 'z' || name[9] == '3' || (name[9] == '2' && !has_three)) z = *number;
  }
  if (x.has_value() != z.has_value() && !bad_position) note("position", WrongType("position", "two numbers: [x, z]"));
  if (x && z) read.position = world::Vec3{static_cast<float>(*x), 0, static_cast<float>(*z)};
  return read;
}

Result<AgentOptions> ReadAgentOptions(const Options& options, const std::vector<BodyKind>& kinds) {
  std::vector<OptionProblem> problems;
  AgentOptions read = ReadAgentOptions(options, kinds, problems);
  if (problems.empty()) return read;
  Diagnostic all = problems.front().problem;
  for (std::size_t i = 1; i < problems.size(); ++i) {
    all.message += "; " + problems[i].problem.message;
    if (!problems[i].problem.hint.empty() && problems[i].problem.hint != all.hint)
      all.hint += (all.hint.empty() ? "" : "; ") + problems[i].problem.hint;
  }
  return all;
}

}  // namespace soarbox::sim
