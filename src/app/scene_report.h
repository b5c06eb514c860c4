// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::app {

/// Returns a recorded run for a page that shows it in 3D (docs/report.md), as JSON: the scene at each moment, and the
/// contents of the minds' panels. Leaves out moments so that it takes at most about 6 MB. The error names what cannot
/// be read.
Result<std::string> RecordedRun(const std::filesystem::path& recording);

}  // namespace soarbox::app
