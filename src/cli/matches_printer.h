// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "cli/print_stream.h"
#include "cli/result_node.h"
#include "cli/trace_settings.h"
#include "kernel/agent.h"

namespace soarbox::cli {

/// Shows how many conditions of a rule match: the number of partial matches up to each condition, and a mark at the
/// first condition without any. `detail` also shows the elements of complete matches, and of those that reach the mark.
void PrintPartialMatches(PrintStream& stream, const kernel::Agent& agent, kernel::ProductionId rule, WmeDetail detail,
                         ResultNode& structured);

/// Shows the rules that are about to fire and the firings that are about to be retracted.
void PrintMatchSet(PrintStream& stream, const kernel::Agent& agent, bool assertions, bool retractions, WmeDetail detail,
                   ResultNode& structured);

}  // namespace soarbox::cli
