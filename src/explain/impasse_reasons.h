// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "explain/mind_view.h"
#include "explain/reason.h"

namespace soarbox::explain {

/// Why none of the operators that are proposed in a state is selected.

/// `below`: the substate of the tie.
std::vector<Reason> ExplainTie(MindView& view, const std::string& state, const std::string& below);
/// `below`: the substate of a conflict or of a constraint failure.
std::vector<Reason> ExplainConflict(MindView& view, const std::string& state, const StackEntry& below);
/// Explains why all operators that are proposed in a state were dropped. Empty if none is proposed, or if the kernel
/// does not report it.
std::string WhyAllDropped(MindView& view, const std::string& state);

}  // namespace soarbox::explain
