// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

/// True if a program of this name stands in one of the folders of PATH.
bool IsInstalled(std::string_view program);

/// Runs a program (no shell) and waits for it, with nothing to read and its output dropped. True if it ended with 0.
bool RunProgram(const std::vector<std::string>& words);

/// Starts a program (no shell) that goes on by itself, with nothing to read and its output dropped.
bool StartProgram(const std::vector<std::string>& words);

/// True if windows can be shown.
bool HasDisplay();

}  // namespace soarbox::cli
