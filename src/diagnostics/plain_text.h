// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace soarbox {

/// A foreign text as a terminal may show it: control characters other than tabs as \xNN, so that no text moves the
/// cursor or colours what is not its own. Lines after the first begin with `indent`, so that none of them passes for a
/// message; a null pointer gives \n instead. A text longer than `most` bytes ends in a count of the rest.
std::string Printable(std::string_view text, const char* indent = "   ", std::size_t most = 4000);

/// Why bytes that were read as rules, a script or a scenario are not what anybody wrote: UTF-16, or a zero byte in
/// them. Empty if they may be.
std::string WhyNoPlainText(std::string_view content);

/// The text after the byte order mark that some editors put before UTF-8.
std::string_view WithoutByteOrderMark(std::string_view content);

}  // namespace soarbox
