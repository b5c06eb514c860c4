// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "explain/why_node.h"
#include "mind/origin.h"

namespace soarbox::explain {

/// Returns the simulated time of a mind's decision in seconds, or nothing if it is not known. If the function is empty,
/// texts give the number of the decision.
using DecisionTime = std::function<std::optional<double>(std::uint64_t decision)>;

/// Explains how an element was made, as the kernel recorded it at that time: the rule, the operator that was selected,
/// the reason of its selection, the rule that proposed it, and what these rules matched, with the values at that time.
/// `is_command`: the sentences call the element a command. Returns nothing if there is no origin.
std::vector<WhyNode> OriginTree(const mind::OriginFacts& facts, const DecisionTime& time, bool is_command);

/// Explains why a command is still on the output link: the operator that gave it is still selected, or it is no longer
/// selected. `selected`: identifiers of the operators that are selected now. Returns nothing if no operator gave the
/// command, or if the command has no o-support.
std::vector<WhyNode> PresentReason(const mind::OriginFacts& facts, const std::vector<std::string>& selected);

}  // namespace soarbox::explain
