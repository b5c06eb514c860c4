// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/learn/explained_rule.h"

/// Graphs of how a rule was learned, in the language of Graphviz.
namespace soarbox::cli {

/// Shows which identities were merged, and which became constants.
std::string IdentityGraphText(const kernel::ExplainedRule& rule, std::string_view line_style);
/// Tables of the conditions and actions of the firings that led to the rule, with an edge from each condition to the
/// firing that made the tested element. Fields with the same identity have the same colour.
std::string AnalysisGraphText(const kernel::ExplainedRule& rule, std::string_view line_style);

}  // namespace soarbox::cli
