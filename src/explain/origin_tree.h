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

/// The simulated time of a mind's decision, in seconds; nothing if it is not known. May be empty: then texts give the
/// number of the decision.
using DecisionTime = std::function<std::optional<double>(std::uint64_t decision)>;

/// How an element came to be, as the kernel noted it then: the rule, the operator that was selected, why that was
/// selected, who proposed it, and what these rules matched, with the values of then. Empty if there is no origin.
std::vector<WhyNode> OriginTree(const mind::OriginFacts& facts, const DecisionTime& time, bool is_command);

/// The present reason that a command is still there: that its operator is selected still, or that it is not any more.
/// `selected`: the identifiers of the operators that are selected now. Empty if no operator was selected then.
std::vector<WhyNode> PresentReason(const mind::OriginFacts& facts, const std::vector<std::string>& selected);

}  // namespace soarbox::explain
