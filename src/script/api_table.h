// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace soarbox::script {

/// What a call with too few or too many arguments does ("arity class" in docs/spec/lua_api.md).
enum class WrongCount : std::uint8_t {
  kIgnored,  ///< Nothing, with a warning, once per place.
  kError,    ///< A Lua error.
};

/// For ApiFunction::more_arguments: any number.
inline constexpr int kAnyCount = 250;

/// One function of the sandbox's API. Scripts call it, and the checks of arguments, the suggestions for misspelt names
/// and the pages of docs/lua/ use its description.
struct ApiFunction {
  std::string_view name;        ///< A literal: "Agent.SetPosition".
  int (*function)(lua_State*);  ///< Runs after the check of the arguments. See api_call.h.
  WrongCount wrong_count;
  /// "agent: Agent, position: Vector [m], seconds: number 0.1..1000 [s] = 0.1"; see ParseArguments.
  std::string_view arguments;
  std::string_view results;  ///< "Vector [m]", "number, table"; empty: none.
  std::string_view text;     ///< What it does, in complete sentences.
  std::string_view example;  ///< Lua; a comment "--> text" ends a line that prints exactly this text.
  bool own = false;          ///< Beyond the 192 functions of the first sandbox.
  int more_arguments = 0;    ///< Number of arguments beyond these that are allowed and ignored.
};

/// The type of an argument. If an argument of the types kSandbox, kObject, kNode, kPlaced, kScene, kMesh and kThing is
/// wrong, the call does nothing, with a warning. Every other wrong argument is a Lua error.
enum class ApiType : std::uint8_t {
  kSandbox,
  kAgent,
  kObject,
  kNode,    ///< A scene node of Core.Create*.
  kPlaced,  ///< An object or a scene node.
  kScene,   ///< An object, a scene node or the sandbox.
  kMesh,    ///< The same, with a skeleton.
  kThing,   ///< A kScene or an agent.
  kUi,
  kAnimation,
  kVector,
  kNumber,
  kString,
  kTable,
  kAgents,  ///< A table of agents, or a string: the name of a team.
  kFunction,
  kBoolean,  ///< Any value, as a truth value in Lua.
  kValue,    ///< Any value: the function checks it.
};

struct ApiArgument {
  std::string_view name;
  std::string_view type_name;
  ApiType type = ApiType::kValue;
  std::string_view unit;           ///< Without brackets; empty: none.
  std::string_view default_value;  ///< Only if optional.
  bool optional = false;
  std::string_view range;  ///< Of numbers, and of each component of vectors: "0..1", "0..inf"; empty: any finite value.
  double low = -std::numeric_limits<float>::max(), high = std::numeric_limits<float>::max();
};

/// A table of the API with its functions, sorted by name.
struct ApiGroup {
  std::string_view name;  ///< A literal; of the table: "Agent".
  std::string_view text;  ///< The purpose of the group.
  std::vector<ApiFunction> functions;
};
std::span<const ApiGroup> ApiGroups();

/// Returns the function with this full name, or null.
const ApiFunction* FindApiFunction(std::string_view name);
/// Parses the `arguments` of a function. An unknown type is a programmer's error.
std::vector<ApiArgument> ParseArguments(std::string_view arguments);
/// Returns the name in this table that a misspelt name most likely means; empty if none is near.
std::string_view SuggestApiName(std::string_view table, std::string_view name);

// The parts of the tables, each with its functions in the file bind_*.cpp of its name.
std::span<const ApiFunction> AgentPropertiesApi();
std::span<const ApiFunction> AgentShowApi();
std::span<const ApiFunction> AgentSteeringApi();
std::span<const ApiFunction> AgentStrideApi();
std::span<const ApiFunction> AnimationApi();
std::span<const ApiFunction> AnimationBonesApi();
std::span<const ApiFunction> CoreCreateApi();
std::span<const ApiFunction> CoreDrawApi();
std::span<const ApiFunction> CorePhysicsApi();
std::span<const ApiFunction> CoreSceneApi();
std::span<const ApiFunction> SandboxCreateApi();
std::span<const ApiFunction> SandboxEventsApi();
std::span<const ApiFunction> SandboxInfluenceApi();
std::span<const ApiFunction> SandboxNavigationApi();
std::span<const ApiFunction> SandboxViewApi();
std::span<const ApiFunction> UiApi();
std::span<const ApiFunction> VectorApi();

}  // namespace soarbox::script
