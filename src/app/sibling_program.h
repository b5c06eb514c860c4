// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <system_error>

namespace soarbox::app {

/// Returns the path of a program next to this one; sets `error` if the system does not report this program's path.
std::filesystem::path BesideThisProgram(const char* name, std::error_code& error);

/// Replaces this process by the program `name` in the same folder, with the same arguments. Returns only if it cannot
/// be started.
void GoOnAs(const char* name, char** argv);

}  // namespace soarbox::app
