// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "cli/print_stream.h"
#include "cli/result_node.h"
#include "kernel/agent.h"

namespace soarbox::cli {

/// "input", "propose", "decision", "apply" or "output".
const char* PhaseName(kernel::Phase phase);

/// "tie", "no-change"; "none" for none.
const char* ImpasseName(kernel::ImpasseType type);

/// "(operator tie)", "(state no-change)"; empty for the top state.
std::string ImpasseText(const kernel::GoalInfo& goal);

/// The line of a state, without its line end: "     1:    ==>S: S2 (operator tie)". The line of the top state ends with
/// a blank. `cycle` is the text before the colon, six columns wide.
std::string StateLine(const kernel::Agent& agent, const kernel::GoalInfo& goal, const std::string& cycle);

/// The line of the operator selected in a goal: "     1:    O: O1 (name)".
std::string OperatorLine(const kernel::Agent& agent, const kernel::GoalInfo& goal, const std::string& cycle);

/// An operator with its name: "O1 (name)". For evaluate-object, its objects are added: "O1 (evaluate-object P1
/// (pump))".
std::string OperatorText(const kernel::Agent& agent, kernel::Symbol op);

/// The name of an operator; the first if it has several, empty if it has none.
std::string OperatorName(const kernel::Agent& agent, kernel::Symbol op);

/// Prints the goal stack, top state first.
void PrintStack(PrintStream& stream, const kernel::Agent& agent, bool states, bool operators, ResultNode& structured);

}  // namespace soarbox::cli
