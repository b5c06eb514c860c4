// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "kernel/learn/explained_rule.h"

/// How a rule was learned, as `explain` prints it.
namespace soarbox::cli {

/// Whether a rule of this name is still loaded. Once its rule is excised, the tests of a firing are not shown.
using LoadedRules = std::function<bool(const std::string& name)>;

/// The learned rule, with the identities behind its variables.
std::string ExplainedRuleText(const kernel::ExplainedRule& rule, bool elements, const LoadedRules& loaded);
/// The match that the learned rule began with, as one of the firings.
kernel::ExplainedRule::Firing LearnedInstance(const kernel::ExplainedRule& rule);
/// One of the firings behind it: its tests and identities, or (`elements`) the elements that it matched.
std::string ExplainedFiringText(const kernel::ExplainedRule& rule, const kernel::ExplainedRule::Firing& firing,
                                bool elements, const LoadedRules& loaded);
std::string FormationText(const kernel::ExplainedRule& rule, bool elements, const LoadedRules& loaded);
std::string IdentityText(const kernel::ExplainedRule& rule);
std::string ConstraintsText(const kernel::ExplainedRule& rule);
std::string ExplainedStatisticsText(const kernel::ExplainedRule& rule);
/// What else you can ask.
std::string ExplainMenu(bool elements);

}  // namespace soarbox::cli
