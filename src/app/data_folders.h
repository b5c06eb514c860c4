// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// Where the program's scenarios and media lie: $SOARBOX_DATA if set, else share/soarbox beside the installed program,
/// else the source tree that it was built from. The error names all places that were tried.
Result<sim::DataFolders> FindDataFolders();
/// Where the built page of browsers lies beside them, if it was built.
std::filesystem::path PageFolder(const sim::DataFolders& data);

}  // namespace soarbox::app
