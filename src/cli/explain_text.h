// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "kernel/learn/explained_rule.h"

/// How a rule was learned, as `explain` prints it.
namespace soarbox::cli {

/// The learned rule, with the identities behind its variables.
std::string ExplainedRuleText(const kernel::ExplainedRule& rule, bool elements);
/// One of the firings behind it: its tests and identities, or (`elements`) the elements that it matched.
std::string ExplainedFiringText(const kernel::ExplainedRule& rule, const kernel::ExplainedRule::Firing& firing,
                                bool elements);
std::string FormationText(const kernel::ExplainedRule& rule, bool elements);
std::string IdentityText(const kernel::ExplainedRule& rule);
std::string ConstraintsText(const kernel::ExplainedRule& rule);
std::string ExplainedStatisticsText(const kernel::ExplainedRule& rule);
/// What else can be asked.
std::string ExplainMenu(bool elements);

}  // namespace soarbox::cli
