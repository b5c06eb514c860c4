// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <system_error>

namespace soarbox::app {

/// The file of that name beside this program's; an error where the system does not say where this one is.
std::filesystem::path BesideThisProgram(const char* name, std::error_code& error);

/// Goes on as the program of this name in the same folder, with the same arguments. Returns only if it cannot be
/// started.
void GoOnAs(const char* name, char** argv);

}  // namespace soarbox::app
