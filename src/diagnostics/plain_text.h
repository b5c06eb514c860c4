// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace soarbox {

/// The beginning of a text: at most `most` bytes, and no part of a UTF-8 character.
std::string_view Beginning(std::string_view text, std::size_t most);

/// Makes an untrusted text safe for a terminal. Control characters except tabs are printed as \xNN, so that a text
/// cannot move the cursor or change colours. Lines after the first begin with `indent`, so that none of them looks like
/// a message; if `indent` is null, line ends are printed as \n. A text longer than `most` bytes is truncated and ends
/// with the number of omitted bytes.
std::string Printable(std::string_view text, const char* indent = "   ", std::size_t most = 4000);

/// Why bytes that were read as rules, a script or a scenario are not a text file: they are UTF-16 or contain a zero
/// byte. Empty if they can be text.
std::string WhyNoPlainText(std::string_view content);

/// The text without the byte order mark that some editors add to UTF-8.
std::string_view WithoutByteOrderMark(std::string_view content);

}  // namespace soarbox
