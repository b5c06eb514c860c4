// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::serve {

/// A random id of 128 bits, as 26 letters and digits (base 32 without i, l, o and u).
std::string NewId();
/// Whether a text has the form of an id.
bool IsId(std::string_view text);
/// Compares two secrets in constant time.
bool SameSecret(std::string_view given, std::string_view wanted);

}  // namespace soarbox::serve
