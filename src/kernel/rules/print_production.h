// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/base/symbol_table.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// Maximum length of a printed line. Longer objects continue in an indented line.
inline constexpr std::size_t kPrintColumns = 80;

struct RulePrintOptions {
  bool internal = false;  ///< One line per condition and action, in match and firing order (`print -i`).
  bool complete = false;  ///< Also what `print` leaves out: all digits of numbers, and `:explain`.
};

/// Prints a rule as `print` does, in a form that can be read again: "sp {name\n ... }\n".
std::string PrintProduction(const SymbolTable& symbols, const Production& production,
                            const RulePrintOptions& options = {});

// Parts of rules, for `matches`, `production find`, explanations and messages.

void AppendTest(std::string& out, const SymbolTable& symbols, const Test& test, bool all_digits = false);
void AppendRhsValue(std::string& out, const SymbolTable& symbols, const RhsValue& value, bool all_digits = false);
void AppendTest(std::string& out, const SymbolTable& symbols, const TestDraft& test);
void AppendRhsValue(std::string& out, const SymbolTable& symbols, const ValueDraft& value);
/// Appends one action: "(<s> ^name value +)" or "(write ...)". The sign of an acceptable preference is shown only for
/// the attribute `operator`.
void AppendAction(std::string& out, const SymbolTable& symbols, const Action& action);
/// Like AppendAction, but always shows the sign of an acceptable preference.
void AppendUngroundedAction(std::string& out, const SymbolTable& symbols, const ActionDraft& action);
/// Appends a condition in one line: "(<s> ^name value)", "(<s> -^name value)" or "-{ (...) (...)}". Includes the word
/// `state` if the condition tests for a state.
void AppendCondition(std::string& out, const SymbolTable& symbols, const Condition& condition);

/// The sign of a comparison followed by a space: "<> ", "@ ". Empty for tests without a sign.
std::string_view ComparisonSign(TestKind kind);
/// The sign of a preference without its referent: "+", ">", "=".
std::string_view PreferenceSign(PreferenceType type);

}  // namespace soarbox::kernel
