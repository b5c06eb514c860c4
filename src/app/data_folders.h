// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// Finds the program's scenarios and media: in $SOARBOX_DATA if set, else in share/soarbox next to the installed
/// program, else in the source tree of the build. The error names all places that were tried.
Result<sim::DataFolders> FindDataFolders();
/// Returns the folder of the built page for browsers, next to these folders, if it was built.
std::filesystem::path PageFolder(const sim::DataFolders& data);

}  // namespace soarbox::app
