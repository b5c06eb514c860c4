// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "diagnostics/result.h"
#include "sim/body_kind.h"
#include "world/math.h"

namespace soarbox::sim {

/// Options as written in scripts and scenario files. Nested options have dotted names: "position.x", "senses.sight".
using Options = std::map<std::string, std::variant<bool, double, std::string>>;

/// The options of an agent that its author can set where the agent is created.
struct AgentOptions {
  BodyKind body;
  bool has_senses = false;  ///< An option of the senses was given.
  std::string team;         ///< Empty: the default of the sandbox.
  std::string leader;       ///< Name of an existing agent.
  std::optional<world::Vec3> position;
  std::optional<float> heading_deg;
  std::optional<double> rounds;
  bool by_sandbox = false;  ///< The sandbox's script defines its body, percepts and commands.
};

/// A problem of one option, with the option's dotted name.
struct OptionProblem {
  std::string option;
  Diagnostic problem;
};

/// Keys of the entire scenario. Authors often write them after a table, so that they become part of that table.
inline bool IsOfWholeScenario(std::string_view key) {
  return key == "seconds" || key == "seed" || key == "description";
}
inline constexpr const char* kOnTop = "it belongs on top of the file, above the first [[...]]";

/// Reads options. Adds one problem for each invalid option, with a suggestion for unknown names. `kinds` are the
/// available kinds of bodies.
AgentOptions ReadAgentOptions(const Options& options, const std::vector<BodyKind>& kinds,
                              std::vector<OptionProblem>& problems);
/// The same. All problems are returned as one diagnostic.
Result<AgentOptions> ReadAgentOptions(const Options& options, const std::vector<BodyKind>& kinds);

/// Sets one property of a body by the name of its option ("speed", "senses.sight", "weapon.range"). Returns false if
/// there is no such property. Fails if the value has the wrong type or is out of range.
Result<bool> SetBodyProperty(BodyKind& body, const std::string& name,
                             const std::variant<bool, double, std::string>& value);

}  // namespace soarbox::sim
