// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "cli/session.h"

namespace soarbox::cli {

/// What `smem ?`, `smem` and `smem --stats` show.
std::string SmemHelpTable(const SettingStore& settings);
std::string SmemSummary(Session& session);
std::string SmemStatistics(Session& session);
/// One figure of the statistics, as text; empty for an unknown name.
std::string SmemStatistic(Session& session, const std::string& name);

}  // namespace soarbox::cli
