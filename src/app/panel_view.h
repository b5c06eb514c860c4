// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "app/inspect_command.h"
#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// Returns a panel of the window and of pages at the moment that the options specify, as text or as one line of JSON.
/// `panel` is its word: "rules".
Result<std::string> ShowPanel(const InspectOptions& options, const std::string& panel, const sim::DataFolders& data);

}  // namespace soarbox::app
