// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// A page that shows a recorded run in 3D, with all that it needs inside (docs/report.md): the scene moment after
/// moment, and what panels show of minds. `nonce`: of the scripts in it. Moments are left out until it takes some 6 MB
/// at most. Empty if the front end was not built. The error names what cannot be read.
Result<std::string> ScenePage(const std::filesystem::path& recording, const sim::DataFolders& data,
                              const std::string& nonce);

}  // namespace soarbox::app
