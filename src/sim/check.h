// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "sim/scenario.h"

namespace soarbox::sim {

/// Looks over files of rules, Lua and scenario files without running them: what does not parse, and what is likely a
/// slip: attributes that nothing writes, commands that no body knows, operators that are proposed and never applied.
/// Folders stand for the files in them. Problems come in the order of the files.
std::vector<Diagnostic> CheckFiles(const std::vector<std::filesystem::path>& files);

}  // namespace soarbox::sim
