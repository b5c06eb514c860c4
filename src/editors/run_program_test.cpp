// SPDX-License-Identifier: BSD-2-Clause
#include "editors/run_program.h"

#include <gtest/gtest.h>

namespace soarbox::editors {
namespace {

TEST(RunProgram, ReturnsOutputsAndExitCode) {
  const ProgramEnd end = RunProgram({"/bin/sh", "-c", "echo one; echo two >&2; exit 3"});
  EXPECT_EQ(end.code, 3);
  EXPECT_EQ(end.out, "one\n");
  EXPECT_EQ(end.err, "two\n");
  EXPECT_FALSE(end.hung);
}

TEST(RunProgram, KillsAProgramThatExceedsItsTime) {
  ProgramLimits limits;
  limits.seconds = 0.2;
  EXPECT_TRUE(RunProgram({"/bin/sh", "-c", "exec sleep 1000"}, limits).hung);
  const ProgramEnd silent = RunProgram({"/bin/sh", "-c", "exec sleep 1000 >/dev/null 2>&1"}, limits);
  EXPECT_TRUE(silent.hung) << "it closed its outputs first";
  EXPECT_EQ(silent.code, -1);
}

TEST(RunProgram, DropsOutputBeyondTheLimit) {
  ProgramLimits limits;
  limits.output_bytes = 4;
  const ProgramEnd end = RunProgram({"/bin/sh", "-c", "printf 123456"}, limits);
  EXPECT_EQ(end.out, "1234");
  EXPECT_TRUE(end.is_cut);
  EXPECT_EQ(end.code, 0);
}

}  // namespace
}  // namespace soarbox::editors
