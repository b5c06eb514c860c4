// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/rule_slips.h"

namespace soarbox::explain {

/// A character in a line of rules that is not ASCII. Readers of rules skip it.
struct OddCharacter {
  std::size_t length = 0;  ///< In bytes.
  std::string message, hint;
};

/// Position of the first such character outside bars; npos if there is none.
std::size_t FindOddCharacter(std::string_view line);
/// Describes the character that begins at `at`.
OddCharacter DescribeOddCharacter(std::string_view line, std::size_t at);

/// Position of the first sequence outside bars that a web page substituted for a character: \* for *, &lt; for <. npos
/// if there is none.
std::size_t FindPasted(std::string_view line);
/// Describes the sequence that begins at `at`.
OddCharacter DescribePasted(std::string_view line, std::size_t at);

/// Finds all odd characters of a file. Returns one warning for each character and rule, which names the rule.
std::vector<Diagnostic> FindOddCharacters(const RuleFile& file);

}  // namespace soarbox::explain
