// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::record {

// Programs of users that control Soar agents (robots, other environments) are recorded as a log of what they did to the
// agents (sml/server/client_log.h). Such programs have no world of ours. A log is converted to a recording by running
// the agents again from it, in a world in which their bodies do nothing. A tick is one decision of each agent.

/// Sets the folders of the program's worlds, which the conversion needs. Call it once, before a log is converted.
void SetDataFolders(sim::DataFolders data);

/// Whether the file begins like such a log.
bool IsClientLog(const std::filesystem::path& file);

/// Converts a client's log to a recording. Fails if the log is invalid or contains no decision, or if the recording
/// cannot be written. If the agents behave differently than in the log, an event of the recording says so.
Result<void> RecordClientLog(const std::filesystem::path& log, const std::filesystem::path& recording);

}  // namespace soarbox::record
