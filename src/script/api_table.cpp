// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <string>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {
namespace {

constexpr std::pair<std::string_view, ApiType> kTypes[] = {
    {"Sandbox", ApiType::kSandbox},     {"Agent", ApiType::kAgent},     {"Object", ApiType::kObject},
    {"Node", ApiType::kNode},           {"Placed", ApiType::kPlaced},   {"Scene", ApiType::kScene},
    {"Thing", ApiType::kThing},         {"UI", ApiType::kUi},           {"Vector", ApiType::kVector},
    {"number", ApiType::kNumber},       {"string", ApiType::kString},   {"table", ApiType::kTable},
    {"function", ApiType::kFunction},   {"boolean", ApiType::kBoolean}, {"value", ApiType::kValue},
    {"Animation", ApiType::kAnimation}, {"Agents", ApiType::kAgents},   {"Mesh", ApiType::kMesh},
};

std::vector<ApiFunction> Joined(std::initializer_list<std::span<const ApiFunction>> parts) {
  std::vector<ApiFunction> all;
  for (const auto part : parts) all.insert(all.end(), part.begin(), part.end());
  std::ranges::sort(all, {}, &ApiFunction::name);
  return all;
}

std::string_view Trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// "0..1".
void ParseRange(std::string_view range, ApiArgument& argument) {
  const std::size_t dots = range.find("..");
  assert(dots != std::string_view::npos);
  argument.range = range;
  argument.low = std::strtod(std::string(range.substr(0, dots)).c_str(), nullptr);
  argument.high = std::strtod(std::string(range.substr(dots + 2)).c_str(), nullptr);
}

/// "name: Type range [unit] = default".
ApiArgument ParseArgument(std::string_view text) {
  ApiArgument argument;
  const std::size_t colon = text.find(':');
  assert(colon != std::string_view::npos);
  argument.name = Trimmed(text.substr(0, colon));
  std::string_view rest = text.substr(colon + 1);
  if (const std::size_t equals = rest.find(" = "); equals != std::string_view::npos) {
    argument.optional = true;
    argument.default_value = Trimmed(rest.substr(equals + 3));
    rest = rest.substr(0, equals);
  }
  if (const std::size_t bracket = rest.find('['); bracket != std::string_view::npos) {
    argument.unit = rest.substr(bracket + 1, rest.find(']') - bracket - 1);
    rest = rest.substr(0, bracket);
  }
  rest = Trimmed(rest);
  const std::size_t space = rest.find(' ');
  argument.type_name = rest.substr(0, space);
  if (space != std::string_view::npos) ParseRange(rest.substr(space + 1), argument);
  bool known = false;
  for (const auto& [name, type] : kTypes) {
    if (name != argument.type_name) continue;
    argument.type = type;
    known = true;
  }
  assert(known);
  (void)known;
  return argument;
}

}  // namespace

std::span<const ApiGroup> ApiGroups() {
  static const ApiGroup kGroups[] = {
      {"Agent",
       "Agents: their properties, and the forces that steer them. Each function is also a method: "
       "`agent:GetPosition()` is `Agent.GetPosition(agent)`.",
       Joined({AgentPropertiesApi(), AgentShowApi(), AgentSteeringApi(), AgentStrideApi()})},
      {"Animation",
       "Animated meshes: their animations and bones. Animation.Play plays an animation; a script can also advance "
       "animations itself.",
       Joined({AnimationApi(), AnimationBonesApi()})},
      {"Core",
       "The scene (everything visible), the bodies of objects, and lines that are drawn for one step. Colours are "
       "vectors of red, green and blue, 0 to 1.",
       Joined({CoreCreateApi(), CoreDrawApi(), CorePhysicsApi(), CoreSceneApi()})},
      {"Sandbox", "The world: objects, agents, events, camera, time, panels, navigation meshes and the influence map.",
       Joined(
           {SandboxCreateApi(), SandboxEventsApi(), SandboxInfluenceApi(), SandboxNavigationApi(), SandboxViewApi()})},
      {"UI",
       "Panels of text, images, bars and buttons on the screen or in the world. Only the sandbox's own scripts have "
       "this table.",
       Joined({UiApi()})},
      {"Vector",
       "Points, directions, colours and rotations. You can add, subtract, multiply and divide vectors by components, "
       "with a vector or a number on the right, and read and set `v.x`, `v.y` and `v.z`. A variable refers to a "
       "vector: if a function changes the vector, its caller sees the change.",
       Joined({VectorApi()})},
  };
  return kGroups;
}

const ApiFunction* FindApiFunction(std::string_view name) {
  static const auto kByName = [] {
    std::map<std::string_view, const ApiFunction*> by_name;
    for (const ApiGroup& group : ApiGroups()) {
      for (const ApiFunction& function : group.functions) by_name[function.name] = &function;
    }
    return by_name;
  }();
  const auto found = kByName.find(name);
  return found == kByName.end() ? nullptr : found->second;
}

std::vector<ApiArgument> ParseArguments(std::string_view arguments) {
  std::vector<ApiArgument> parsed;
  while (!arguments.empty()) {
    const std::size_t comma = arguments.find(',');
    parsed.push_back(ParseArgument(arguments.substr(0, comma)));
    arguments = comma == std::string_view::npos ? std::string_view() : arguments.substr(comma + 1);
  }
  return parsed;
}

std::string_view SuggestApiName(std::string_view table, std::string_view name) {
  std::vector<std::string_view> names;
  for (const ApiGroup& group : ApiGroups()) {
    if (group.name != table) continue;
    for (const ApiFunction& function : group.functions) names.push_back(function.name.substr(table.size() + 1));
  }
  const std::string_view near = Suggest(name, names);
  if (!near.empty() || name.size() < 4) return near;
  // A shorter form or a part of the name: "GetPos".
  std::string_view shortest;
  for (const std::string_view other : names)
    if (other.find(name) != std::string_view::npos && (shortest.empty() || other.size() < shortest.size()))
      shortest = other;
  return shortest;
}

}  // namespace soarbox::script
