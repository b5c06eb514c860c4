// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/syntax_help.h"

#include <algorithm>
#include <vector>

namespace soarbox::kernel {

std::string_view DescribeSyntaxError(std::string_view soar_message) {
  struct Words {
    std::string_view soars, ours;
  };
  constexpr Words kWords[] = {
      {"Illegal value for RHS value", "expected a value: a constant, a variable, or a function call in parentheses"},
      {"Expected ( to begin RHS action", "expected ( to begin an action"},
      {"Expected ^ in RHS make action", "expected ^attribute or ) in an action"},
      {"Expected ( to begin condition element", "expected ( to begin a condition"},
      {"Expected --> in production", "expected another condition, or --> before the actions"},
      {"Expected variable or constant for test", "expected a constant or a variable to test for"},
      {"Expected ^ followed by attribute", "expected ^attribute or ) in a condition"},
      {"Expected } to end conjunctive condition", "expected } to end the conditions that -{ began"},
      {"Expected constant or >> while reading disjunction test", "expected a constant or >> to end the choice"},
      {"Expected symbol for production name", "expected the rule's name"},
  };
  for (const Words& words : kWords) {
    if (words.soars == soar_message) return words.ours;
  }
  return soar_message;
}

std::optional<std::size_t> FindOpenBracket(std::string_view body, std::size_t offset) {
  std::vector<std::size_t> open;
  char quote = 0;
  const std::size_t end = std::min(offset, body.size());
  for (std::size_t at = 0; at < end; ++at) {
    const char c = body[at];
    if (quote != 0) {
      if (c == '\\') {
        ++at;
      } else if (c == quote) {
        quote = 0;
      }
    } else if (c == '|' || c == '"') {
      quote = c;
    } else if (c == '(' || c == '{') {
      open.push_back(at);
    } else if ((c == ')' || c == '}') && !open.empty()) {
      open.pop_back();
    }
  }
  if (open.empty()) return std::nullopt;
  return open.back();
}

}  // namespace soarbox::kernel
