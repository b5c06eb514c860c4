// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "kernel/agent.h"

namespace soarbox::server {

/// What the command line's `run` answers: how many decision cycles and firings the addressed agent had. The count of
/// cycles is Soar's: its counter begins with 1, and a run that starts there counts from 0.
std::string RunText(const kernel::AgentCounters& before, const kernel::Agent& agent, const kernel::RunResult& result);

}  // namespace soarbox::server
