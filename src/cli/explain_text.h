// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "kernel/learn/explained_rule.h"

/// How a rule was learned, as `explain` prints it.
namespace soarbox::cli {

/// Whether a rule of this name is still loaded. If a rule was excised, the tests of its firings are not shown.
using LoadedRules = std::function<bool(const std::string& name)>;

/// The learned rule, with the identities of its variables. With `elements`, the elements that it matched when it was
/// learned.
std::string ExplainedRuleText(const kernel::ExplainedRule& rule, bool elements, const LoadedRules& loaded);
/// The match from which the rule was learned, in the form of a firing.
kernel::ExplainedRule::Firing LearnedInstance(const kernel::ExplainedRule& rule);
/// One of the firings that led to the rule: its tests and identities, or (`elements`) the elements that it matched.
std::string ExplainedFiringText(const kernel::ExplainedRule& rule, const kernel::ExplainedRule::Firing& firing,
                                bool elements, const LoadedRules& loaded);
std::string FormationText(const kernel::ExplainedRule& rule, bool elements, const LoadedRules& loaded);
std::string IdentityText(const kernel::ExplainedRule& rule);
std::string ConstraintsText(const kernel::ExplainedRule& rule);
std::string ExplainedStatisticsText(const kernel::ExplainedRule& rule);
/// The list of further subcommands.
std::string ExplainMenu(bool elements);

}  // namespace soarbox::cli
