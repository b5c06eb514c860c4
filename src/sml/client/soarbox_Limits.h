// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "Export.h"

namespace sml {
class Agent;
}

namespace soarbox {

/// When MindFirings (soarbox_Observation.h) reaches `most`, each phase of the agent ends as if it had reached
/// max-elaborations. Has no effect if the agent's kernel is in another process.
void EXPORT SetMindFiringLimit(sml::Agent& agent, std::uint64_t most);

}  // namespace soarbox
