// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace soarbox::explain {

/// An error about a file of rules, as a kernel prints it. Errors come from a kernel as text, because it can be any
/// kernel, in this process or another. Only ReadKernelError reads that text; all other code uses these values.
struct KernelError {
  enum class Kind : std::uint8_t {
    kOther,
    kExpected,        ///< The parser expected something else: `expected`.
    kUnexpectedEnd,   ///< The file ends within a rule.
    kNoSuchCommand,   ///< `subject`: the command, after expansion of aliases.
    kTooManyToPrint,  ///< `print` takes one argument.
    kNoSuchOption,
    kNoFile,         ///< A sourced file cannot be opened.
    kNotARule,       ///< Text of `sp` that is not one rule in braces.
    kUnboundAction,  ///< An action uses a variable that no condition binds. `subject`: the action, without brackets.
    kConstantAsId,   ///< A constant in place of an identifier. `subject`: the constant.
    kReadAsString,   ///< A word that is read as a string. `subject`: the word.
    kNotClosed,      ///< A bar or a quote that is not closed.
  };
  enum class Expected : std::uint8_t {
    kOther,
    kValue,
    kAction,
    kAttributeOfAction,
    kCondition,
    kConditionOrArrow,
    kTest,  ///< Also the end of a choice.
    kAttributeOfCondition,
    kName,
  };

  Kind kind = Kind::kOther;
  Expected expected = Expected::kOther;
  std::string subject;
  std::string found;    ///< The text that the parser found; empty if there is none.
  std::string rule;     ///< "rule walk*propose: ": the text before what was expected.
  bool at_end = false;  ///< The rule ends where something was expected.

  bool Expects(Expected what) const { return expected == what; }
  /// The parser expected an attribute, in a condition or an action.
  bool ExpectsAttribute() const {
    return expected == Expected::kAttributeOfAction || expected == Expected::kAttributeOfCondition;
  }
};

KernelError ReadKernelError(std::string_view message);

}  // namespace soarbox::explain
