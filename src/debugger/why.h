// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "diagnostics/result.h"
#include "explain/why_node.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

using explain::WhyKind;
using explain::WhyNode;

/// Explains the present behaviour of an agent: command, operators, preferences, elements, percepts.
WhyNode WhyAgent(const sim::Simulation& simulation, std::string_view agent);
/// Explains why an operator is selected or not. `op` is a name or identifier. Returns nothing if no preference mentions
/// it.
std::optional<WhyNode> WhyOperator(explain::Inspector& mind, std::string_view op);
/// Explains why a command is on the output link. Returns nothing if the link has no command of this name.
std::optional<WhyNode> WhyCommand(explain::Inspector& mind, std::string_view command);
/// Explains any name: a command on the output link, or an operator that a preference mentions. For any other name, it
/// explains what prevents the rules from giving, proposing or matching it (Simulation::WhyTopic), below a node of the
/// kind kTopic. Fails if the rules do not contain the name.
Result<WhyNode> WhyName(sim::Simulation& simulation, std::string_view agent, std::string_view name);
/// The same. An error is returned as the text of the answer.
WhyNode WhyNameOrError(sim::Simulation& simulation, std::string_view agent, std::string_view name);
/// Explains the origin of an element, back to the percepts. The depth is limited.
WhyNode WhyElement(explain::Inspector& mind, std::uint64_t timetag);
/// `indent`: number of indentation steps of two blanks.
std::string ToText(const WhyNode& node, std::size_t indent = 0);
Json ToJson(const WhyNode& node);
/// The word for a kind in JSON: "operator".
std::string_view KindWord(WhyKind kind);

}  // namespace soarbox::debugger
