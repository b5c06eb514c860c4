// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::record {

// Programs of users that drive Soar agents themselves (robots, other environments) are recorded as a log of what they
// did to the agents (sml/server/client_log.h): such programs have no world of ours, and their library knows none. A log
// becomes a recording by running the agents again from it, in a world where their bodies do nothing. A tick is one
// decision of each agent.

/// Where the program's worlds are, for logs that become recordings. Set once, before anything opens one.
void SetDataFolders(sim::DataFolders data);

/// Whether the file begins like such a log.
bool IsClientLog(const std::filesystem::path& file);

/// Writes the recording of a client's log. Fails if the log holds no decision or is no log, or if the recording cannot
/// be written. If the agents run another way than in the log, an event of the recording says so.
Result<void> RecordClientLog(const std::filesystem::path& log, const std::filesystem::path& recording);

}  // namespace soarbox::record
