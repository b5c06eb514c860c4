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

/// Why an agent does what it does now: command, operators, preferences, elements, percepts.
WhyNode WhyAgent(const sim::Simulation& simulation, std::string_view agent);
/// Why an operator is selected, or another one is not, by name or identifier; nothing if no preference speaks of it.
std::optional<WhyNode> WhyOperator(explain::Inspector& mind, std::string_view op);
/// Why a command stands on the output link; nothing if none of this name does.
std::optional<WhyNode> WhyCommand(explain::Inspector& mind, std::string_view command);
/// Why, or why not, of any name: a command that stands, an operator that preferences speak of; of others what keeps the
/// rules from saying, proposing or matching it (Simulation::WhyTopic), below a node of the kind "topic". Fails if they
/// know nothing of that name.
Result<WhyNode> WhyName(sim::Simulation& simulation, std::string_view agent, std::string_view name);
/// The same, with an error as the answer.
WhyNode WhyNameOrError(sim::Simulation& simulation, std::string_view agent, std::string_view name);
/// Where an element comes from, back to the percepts, some steps deep.
WhyNode WhyElement(explain::Inspector& mind, std::uint64_t timetag);
/// `indent`: steps of two blanks.
std::string ToText(const WhyNode& node, std::size_t indent = 0);
Json ToJson(const WhyNode& node);
/// The word for a kind in JSON: "operator".
std::string_view KindWord(WhyKind kind);

}  // namespace soarbox::debugger
