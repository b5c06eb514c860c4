// SPDX-License-Identifier: BSD-2-Clause
#include "explain/kernel_error.h"

namespace soarbox::explain {
namespace {

using Kind = KernelError::Kind;
using Expected = KernelError::Expected;

/// The text between two texts; empty if they do not occur.
std::string Between(std::string_view text, std::string_view begin, std::string_view end) {
  const std::size_t from = text.find(begin);
  if (from == std::string_view::npos) return {};
  const std::size_t start = from + begin.size(), to = text.find(end, start);
  return to == std::string_view::npos ? std::string() : std::string(text.substr(start, to - start));
}

/// What the parser expected (kernel/rules/syntax_help.cpp).
struct ExpectedWords {
  std::string_view words;
  Expected expected;
};
constexpr ExpectedWords kExpected[] = {
    {"expected a value", Expected::kValue},
    {"expected ( to begin an action", Expected::kAction},
    {"expected ^attribute or ) in an action", Expected::kAttributeOfAction},
    {"expected ( to begin a condition", Expected::kCondition},
    {"or --> before the actions", Expected::kConditionOrArrow},
    {"expected a constant", Expected::kTest},
    {"expected ^attribute or ) in a condition", Expected::kAttributeOfCondition},
    {"expected the rule's name", Expected::kName},
};

/// Errors that have certain words, and the texts around their subject.
struct KindWords {
  Kind kind;
  bool at_begin;  ///< The message begins with the words.
  std::string_view words;
  std::string_view before = {}, after = {};
};
constexpr KindWords kKinds[] = {
    {Kind::kUnexpectedEnd, true, "unexpected eof"},
    {Kind::kNoSuchCommand, true, "no such command", "no such command '", "'"},
    {Kind::kTooManyToPrint, false, "argument allowed when printing"},
    {Kind::kNoSuchOption, true, "No such option"},
    {Kind::kNoFile, true, "Failed to open file"},
    {Kind::kNotARule, true, "Syntax: sp {"},
    {Kind::kUnboundAction, false, "uses a variable that no condition binds", "the action (", ")"},
    {Kind::kConstantAsId, false, " is used where", "constant ", " is used where"},
    {Kind::kReadAsString, false, " is read as a string", "", " is read as a string"},
};

}  // namespace

KernelError ReadKernelError(std::string_view message) {
  KernelError error;
  error.found = Between(message, "found '", "'");
  error.rule = message.substr(0, message.find("expected"));
  error.at_end = message.ends_with("but the rule ends here");
  for (const ExpectedWords& each : kExpected) {
    if (message.find(each.words) == std::string_view::npos) continue;
    error.kind = Kind::kExpected;
    error.expected = each.expected;
    return error;
  }
  if (message == "this bar or quote is not closed") error.kind = Kind::kNotClosed;
  for (const KindWords& each : kKinds) {
    const std::size_t at = message.find(each.words);
    if (at == std::string_view::npos || (each.at_begin && at != 0)) continue;
    error.kind = each.kind;
    if (!each.after.empty()) error.subject = Between(message, each.before, each.after);
    return error;
  }
  return error;
}

}  // namespace soarbox::explain
