// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace sml {

class Kernel;

/// Loads a shared library and calls its sml_InitLibrary with the words of the command ("name arguments..."). Returns
/// the text that the library returned, or an error message; empty on success.
std::string LoadSmlLibrary(Kernel& kernel, const std::string& command);

}  // namespace sml
