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

/// Options as scripts and scenario files write them, nested ones with dotted names: "position.x", "senses.sight".
using Options = std::map<std::string, std::variant<bool, double, std::string>>;

/// What an author may set for an agent where it is made.
struct AgentOptions {
  BodyKind body;
  bool has_senses = false;  ///< Some option was about senses.
  std::string team;         ///< Empty: the sandbox's default.
  std::string leader;       ///< Name of an agent that is there already.
  std::optional<world::Vec3> position;
  std::optional<float> heading_deg;
  std::optional<double> rounds;
  bool by_sandbox = false;  ///< Its body, percepts and commands are up to the sandbox's script.
};

/// What is wrong with one option, by its dotted name.
struct OptionProblem {
  std::string option;
  Diagnostic problem;
};

/// Keys that belong on top of a scenario file but are often written below a table, which then takes them.
inline bool IsOfWholeScenario(std::string_view key) {
  return key == "seconds" || key == "seed" || key == "description";
}
inline constexpr const char* kOnTop = "it belongs on top of the file, above the first [[...]]";

/// Reads the options against the kinds of bodies. Adds what is wrong to the problems, one for each option, with a
/// suggestion for an option that nothing knows.
AgentOptions ReadAgentOptions(const Options& options, const std::vector<BodyKind>& kinds,
                              std::vector<OptionProblem>& problems);
/// The same, with all that is wrong in one diagnostic.
Result<AgentOptions> ReadAgentOptions(const Options& options, const std::vector<BodyKind>& kinds);

/// Sets one property of a body by its option's name ("speed", "senses.sight", "weapon.range"). False if there is no
/// such property; an error if the value is of the wrong type or out of range.
Result<bool> SetBodyProperty(BodyKind& body, const std::string& name,
                             const std::variant<bool, double, std::string>& value);

}  // namespace soarbox::sim
