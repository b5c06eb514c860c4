// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace sml {

class Kernel;

/// Loads a shared library and calls its sml_InitLibrary with the words of the command ("name arguments..."). Returns
/// what the library returned, or a message that says what failed; empty if all is well.
std::string LoadSmlLibrary(Kernel& kernel, const std::string& command);

}  // namespace sml
