// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "cli/print_stream.h"
#include "kernel/agent.h"

namespace soarbox::cli {

/// `production find`: prints the names of the rules that have a matching condition for each condition of the pattern.
/// Learned rules come after all others; within both groups, newer rules come first. A variable of the pattern must
/// match the same variable of the rule everywhere; `*` matches any single test. Negated conditions of rules are
/// ignored. Without `searches`, the pattern is only parsed.
void FindRules(PrintStream& stream, kernel::Agent& agent, const std::string& pattern, bool searches, bool show_bindings,
               const std::function<bool(const kernel::Production&)>& wanted);

}  // namespace soarbox::cli
