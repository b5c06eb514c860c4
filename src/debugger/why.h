// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

/// One step of an answer. What `link` names can be looked at, and asked about in turn.
struct WhyNode {
  std::string text;
  std::string kind;  ///< "agent", "command", "operator", "preference", "rule", "element", "percept", "reason".
  std::string link;  ///< The agent's, operator's or rule's name, or an element's time tag; may be empty.
  std::vector<WhyNode> below;
};

/// Why an agent does what it does now: command, operators, preferences, elements, percepts.
WhyNode WhyAgent(const sim::Simulation& simulation, std::string_view agent);
/// Why an operator is selected, or another one is not. By name or identifier.
WhyNode WhyOperator(sim::Inspector& mind, std::string_view op);
/// Why a command stands on the output link.
WhyNode WhyCommand(sim::Inspector& mind, std::string_view command);
/// Where an element comes from, back to the percepts, some steps deep.
WhyNode WhyElement(sim::Inspector& mind, std::uint64_t timetag);
/// Why no operator or command of this name is proposed, selected or said: the rules that would, and where they stop.
WhyNode WhyNot(sim::Inspector& mind, std::string_view name);

std::string ToText(const WhyNode& node);
Json ToJson(const WhyNode& node);

}  // namespace soarbox::debugger
