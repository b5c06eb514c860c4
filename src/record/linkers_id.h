// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::record {

/// What identifies this program, in hexadecimal: in ELF the linker's note (ld --build-id), in WebAssembly a digest of
/// the module. Empty if there is none.
std::string LinkersId();

}  // namespace soarbox::record
