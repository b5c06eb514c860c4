// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

/// Whether a program of this name is in a folder of PATH.
bool IsInstalled(std::string_view program);

/// Runs a program without a shell and without input, drops its output, and waits for its end. Returns true if its exit
/// status is 0.
bool RunProgram(const std::vector<std::string>& words);

/// Starts a program without a shell and without input, drops its output, and does not wait for it.
bool StartProgram(const std::vector<std::string>& words);

/// Whether windows can be opened.
bool HasDisplay();

}  // namespace soarbox::cli
