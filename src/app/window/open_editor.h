// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::app {

/// Returns the command that opens a file at a line (0: none): $VISUAL, $EDITOR, else the desktop's default. The line is
/// passed to editors whose syntax for it is known.
std::vector<std::string> EditorCommand(const std::string& file, int line);

/// Opens the file without waiting. Fails if there is no such file or no program can be started.
Result<void> OpenInEditor(const std::string& file, int line);

}  // namespace soarbox::app
