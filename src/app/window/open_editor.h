// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::app {

/// The command that opens a file at a line (0: anywhere): $VISUAL, $EDITOR, else the desktop's choice. Editors whose
/// way to name a line we know get it.
std::vector<std::string> EditorCommand(const std::string& file, int line);

/// Opens it beside the running program. Fails if there is no such file or no program can be started.
Result<void> OpenInEditor(const std::string& file, int line);

}  // namespace soarbox::app
