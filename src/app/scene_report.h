// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::app {

/// A recorded run as a page shows it in 3D (docs/report.md), as JSON: the scene moment after moment, and what panels
/// show of minds. Moments are left out until it takes some 6 MB at most. The error names what cannot be read.
Result<std::string> RecordedRun(const std::filesystem::path& recording);

}  // namespace soarbox::app
