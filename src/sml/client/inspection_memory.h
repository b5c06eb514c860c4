// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "soarbox_Inspection.h"

namespace soarbox {

/// The contents of an agent's long-term memories. See MindInspection.
mind::LongTermFacts InspectLongTerm(kernel::Agent& agent, std::size_t most, std::string_view text);
std::vector<mind::RememberedFact> InspectEpisode(kernel::Agent& agent, std::size_t number);

}  // namespace soarbox
