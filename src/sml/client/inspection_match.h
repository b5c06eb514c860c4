// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/agent.h"
#include "soarbox_Inspection.h"

namespace soarbox {

mind::ElementFact InspectElement(const kernel::Agent& agent, kernel::WmeId wme);

/// How far a rule matches, and what its first failing condition saw.
mind::MatchFacts InspectMatch(const kernel::Agent& agent, kernel::ProductionId rule);

/// The number of complete matches of a rule.
std::size_t CountMatches(const kernel::Agent& agent, kernel::ProductionId rule);

/// The rules that test an element, in the order of loading.
std::vector<mind::TesterFact> InspectTesters(const kernel::Agent& agent, kernel::WmeId wme);

}  // namespace soarbox
