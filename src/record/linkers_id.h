// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::record {

/// A hexadecimal id of this program: the linker's note in ELF (ld --build-id), a digest of the module in WebAssembly.
/// Empty if there is none.
std::string LinkersId();

}  // namespace soarbox::record
