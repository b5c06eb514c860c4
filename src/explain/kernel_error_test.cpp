// SPDX-License-Identifier: BSD-2-Clause
#include "explain/kernel_error.h"

#include <gtest/gtest.h>

namespace soarbox::explain {
namespace {

using Kind = KernelError::Kind;
using Expected = KernelError::Expected;

TEST(KernelErrors, OfTheParserHaveWhatWasExpectedAndFound) {
  const KernelError error =
      ReadKernelError("rule a: expected another condition, or --> before the actions, found 'not'");
  EXPECT_EQ(error.kind, Kind::kExpected);
  EXPECT_TRUE(error.Expects(Expected::kConditionOrArrow));
  EXPECT_FALSE(error.at_end);
  EXPECT_EQ(error.found, "not");
  EXPECT_EQ(error.rule, "rule a: ");
  EXPECT_TRUE(
      ReadKernelError("rule a: expected another condition, or --> before the actions, but the rule ends here").at_end);
  EXPECT_TRUE(ReadKernelError("rule a: expected ^attribute or ) in an action, found 'x'").ExpectsAttribute());
  EXPECT_EQ(ReadKernelError("rule a: expected } to end the conditions that -{ began, found '-->'").rule, "rule a: ");
}

TEST(KernelErrors, HaveTheirSubject) {
  const KernelError unbound =
      ReadKernelError("rule a: the action (<op> ^name go +) uses a variable that no condition binds");
  EXPECT_EQ(unbound.kind, Kind::kUnboundAction);
  EXPECT_EQ(unbound.subject, "<op> ^name go +");
  const KernelError constant = ReadKernelError("constant sate is used where only a variable can match an identifier");
  EXPECT_EQ(constant.kind, Kind::kConstantAsId);
  EXPECT_EQ(constant.subject, "sate");
  const KernelError command = ReadKernelError("no such command 'exit'");
  EXPECT_EQ(command.kind, Kind::kNoSuchCommand);
  EXPECT_EQ(command.subject, "exit");
  const KernelError word = ReadKernelError("above> is read as a string, not as a variable");
  EXPECT_EQ(word.kind, Kind::kReadAsString);
  EXPECT_EQ(word.subject, "above>");
}

TEST(KernelErrors, OfOtherKindsHaveNoSubject) {
  EXPECT_EQ(ReadKernelError("this bar or quote is not closed").kind, Kind::kNotClosed);
  EXPECT_EQ(ReadKernelError("unexpected eof while reading").kind, Kind::kUnexpectedEnd);
  const KernelError other = ReadKernelError("something that no kernel prints");
  EXPECT_EQ(other.kind, Kind::kOther);
  EXPECT_EQ(other.subject, "");
  EXPECT_EQ(other.found, "");
}

}  // namespace
}  // namespace soarbox::explain
