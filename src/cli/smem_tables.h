// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "cli/session.h"

namespace soarbox::cli {

/// The output of `smem ?`, `smem` and `smem --stats`.
std::string SmemHelpTable(const SettingStore& settings);
std::string SmemSummary(Session& session);
std::string SmemStatistics(Session& session);
/// One value of the statistics, as text; empty for an unknown name.
std::string SmemStatistic(Session& session, const std::string& name);

}  // namespace soarbox::cli
