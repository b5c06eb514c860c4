// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/base/symbol_table.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// How many characters a printed line may hold; longer objects continue in an indented line.
inline constexpr std::size_t kPrintColumns = 80;

struct RulePrintOptions {
  bool internal = false;  ///< One line per condition and action, in match and firing order (`print -i`).
};

/// A rule as `print` shows it, in a form that can be read again: "sp {name\n ... }\n". The text ends after the brace's
/// line end.
std::string PrintProduction(const SymbolTable& symbols, const Production& production,
                            const RulePrintOptions& options = {});

// The parts, for `matches`, `production find`, explanations and messages.

void AppendTest(std::string& out, const SymbolTable& symbols, const Test& test);
void AppendRhsValue(std::string& out, const SymbolTable& symbols, const RhsValue& value);
void AppendTest(std::string& out, const SymbolTable& symbols, const TestDraft& test);
void AppendRhsValue(std::string& out, const SymbolTable& symbols, const ValueDraft& value);
/// "(<s> ^name value +)" or "(write ...)": one action on its own. The sign of an acceptable preference is shown for
/// the attribute operator only.
void AppendAction(std::string& out, const SymbolTable& symbols, const Action& action);
/// As AppendAction, with the sign of an acceptable preference always shown.
void AppendUngroundedAction(std::string& out, const SymbolTable& symbols, const ActionDraft& action);
/// "(<s> ^name value)", "(<s> -^name value)" or "-{ (...) (...)}" in one line; with `state` if the condition tests for
/// a state.
void AppendCondition(std::string& out, const SymbolTable& symbols, const Condition& condition);

/// The sign of a comparison with a space after it: "<> ", "@ "; empty for tests without a sign.
std::string_view ComparisonSign(TestKind kind);
/// The sign of a preference: "+", ">", "=", without its referent.
std::string_view PreferenceSign(PreferenceType type);

}  // namespace soarbox::kernel
