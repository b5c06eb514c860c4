// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "diagnostics/number_from_chars.h"
#include "explain/rule_text.h"

// Helpers that several searches for slips (rule_slips_*.cpp) use.

namespace soarbox::explain {

inline bool IsNumber(std::string_view word) {
  double number = 0;
  const auto [end, error] = NumberFromChars(word, number);
  return error == std::errc{} && end == word.data() + word.size();
}

/// The variables of a rule that are bound to states.
inline std::set<std::string> StatesOf(const RuleText& rule) {
  std::set<std::string> states;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.on_state) states.insert(condition.id);
  return states;
}

/// Whether a condition binds the value of an action. If not, the action creates the value.
inline bool IsBoundByConditions(const RuleText& rule, std::string_view value) {
  for (const RuleAttribute& condition : rule.conditions)
    if (FirstWord(condition.value) == value) return true;
  return false;
}

}  // namespace soarbox::explain
