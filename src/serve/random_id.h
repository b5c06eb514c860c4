// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::serve {

/// 128 bits that nobody can guess, as 26 letters and digits (base 32 without i, l, o and u).
std::string NewId();
/// Whether a text could be one.
bool IsId(std::string_view text);
/// Whether two secrets are equal, in a time that tells nothing of where they differ.
bool SameSecret(std::string_view given, std::string_view wanted);

}  // namespace soarbox::serve
