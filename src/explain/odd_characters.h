// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/rule_slips.h"

namespace soarbox::explain {

/// A character that is not ASCII, in a line of rules: readers of rules skip it.
struct OddCharacter {
  std::size_t length = 0;  ///< In bytes.
  std::string message, hint;
};

/// Where the first one outside of bars is; npos if there is none.
std::size_t FindOddCharacter(std::string_view line);
/// What is wrong with the one that begins here.
OddCharacter DescribeOddCharacter(std::string_view line, std::size_t at);

/// Where a web page wrote something else for the character that is meant, outside of bars: \* for *, &lt; for <. Npos
/// if nowhere.
std::size_t FindPasted(std::string_view line);
/// What is wrong with what begins here.
OddCharacter DescribePasted(std::string_view line, std::size_t at);

/// All of a file, once for each character and rule, as warnings with the names of their rules.
std::vector<std::pair<std::string, Diagnostic>> FindOddCharacters(const RuleFile& file);

}  // namespace soarbox::explain
