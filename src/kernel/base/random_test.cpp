// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/base/random.h"

#include <gtest/gtest.h>

namespace soarbox::kernel {
namespace {

TEST(RandomStream, SeedOneGivesTheSequenceThatSoarGives) {
  RandomStream stream(1);
  EXPECT_NEAR(stream.Real(), 0.417022, 5e-7);
  EXPECT_NEAR(stream.Real(10), 9.971848, 5e-7);
  EXPECT_EQ(stream.Next32(), 3093770124u);
  EXPECT_EQ(stream.Integer(1), 0u);
  EXPECT_EQ(stream.Integer(10), 9u) << "491263 is rejected first";
  EXPECT_EQ(stream.Integer(100), 75u);
  EXPECT_EQ(stream.Next32(), 4290846341u);
}

TEST(RandomStream, SeedingStartsTheStreamAgain) {
  RandomStream stream(7);
  const std::uint32_t first = stream.Next32();
  stream.Next32();
  stream.Seed(7);
  EXPECT_EQ(stream.Next32(), first);
}

TEST(RandomStream, ACopyContinuesWhereTheOriginalStands) {
  RandomStream stream(3);
  stream.Next32();
  RandomStream copy = stream;
  EXPECT_EQ(copy.Next32(), stream.Next32());
}

TEST(RandomStream, TheLargestLimitIsAllowed) {
  RandomStream stream(1);
  EXPECT_EQ(stream.Integer(0xFFFFFFFFu), 1791095845u);
  EXPECT_EQ(stream.Integer(0), 0u);
}

}  // namespace
}  // namespace soarbox::kernel
