// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

/// True if a program of this name is in one of the folders of PATH.
bool IsInstalled(std::string_view program);

/// Runs a program (no shell) and waits for it, without input and with its output dropped. True if its exit status is 0.
bool RunProgram(const std::vector<std::string>& words);

/// Starts a program (no shell) that runs on its own, without input and with its output dropped.
bool StartProgram(const std::vector<std::string>& words);

/// True if windows can be shown.
bool HasDisplay();

}  // namespace soarbox::cli
