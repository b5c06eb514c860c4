// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/rule_slips.h"

namespace soarbox::explain {

/// A character that is not ASCII, or a sequence that a web page substituted for a character, in a line of rules.
struct OddCharacter {
  std::size_t length = 0;  ///< In bytes.
  std::string message, hint;
  bool is_blank = false;  ///< It looks like a blank, and parsers read it as one.
};

/// Position of the first character outside bars that is not ASCII; npos if there is none. Parsers of rules skip it.
std::size_t FindOddCharacter(std::string_view line);
/// Describes the character that begins at `at`.
OddCharacter DescribeOddCharacter(std::string_view line, std::size_t at);

/// Position of the first sequence outside bars that a web page substituted for a character: \* for *, &lt; for <. npos
/// if there is none.
std::size_t FindPasted(std::string_view line);
/// Describes the sequence that begins at `at`.
OddCharacter DescribePasted(std::string_view line, std::size_t at);

/// Finds characters in the rules of a file that are not ASCII. Returns at most 20 warnings, and at most one for each
/// line. Skips a line if the last warning about the same rule reports the same character.
std::vector<Diagnostic> FindOddCharacters(const RuleFile& file);

}  // namespace soarbox::explain
