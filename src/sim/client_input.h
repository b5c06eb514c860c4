// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "mind/input_writer.h"

namespace sml {
class Agent;
}

namespace soarbox::sim {

/// Writes the input of an agent of any kernel through the client API, which has a copy of the input and writes it again
/// after init-soar. Destroy it before the agent.
std::unique_ptr<mind::InputWriter> OpenClientInput(sml::Agent& agent);

}  // namespace soarbox::sim
