// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/learn/explained_rule.h"

/// Drawings of how a rule was learned, in the language of Graphviz.
namespace soarbox::cli {

/// Which identities were merged, and which became constants.
std::string IdentityGraphText(const kernel::ExplainedRule& rule, std::string_view line_style);
/// Tables of the conditions and actions of the firings behind the rule, with an edge from each condition to the firing
/// that made the element it tested. Fields of one identity have one colour.
std::string AnalysisGraphText(const kernel::ExplainedRule& rule, std::string_view line_style);

}  // namespace soarbox::cli
