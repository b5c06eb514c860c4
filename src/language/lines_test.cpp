// SPDX-License-Identifier: BSD-2-Clause
#include "language/lines.h"

#include <gtest/gtest.h>

namespace soarbox::language {
namespace {

TEST(Lines, PositionsCountUnitsOfUtf16) {
  const std::string text = "aä😀b\nc\r\n";
  const Lines lines(text);
  EXPECT_EQ(lines.PositionOf(text.find('b')), (Position{0, 4}));
  EXPECT_EQ(lines.OffsetOf({0, 4}), text.find('b'));
  EXPECT_EQ(lines.Line(1), "c");
  EXPECT_EQ(lines.PositionOf(text.size()), (Position{2, 0}));
}

TEST(Lines, PositionsOutsideAreTheNearestPlace) {
  const Lines lines("ab\ncd");
  EXPECT_EQ(lines.OffsetOf({0, 99}), 2U);
  EXPECT_EQ(lines.OffsetOf({99, 0}), 5U);
  EXPECT_EQ(lines.PositionOf(99), (Position{1, 2}));
}

TEST(Lines, BytesThatAreNoUtf8AreOneUnitEach) {
  const std::string text = "\xff\xc3(";
  const Lines lines(text);
  EXPECT_EQ(lines.PositionOf(3), (Position{0, 3}));
  EXPECT_EQ(lines.OffsetOf({0, 2}), 2U);
}

TEST(Lines, EveryOffsetOfACharactersBeginComesBack) {
  const std::string text = "x😀y\nä\n\nz";
  const Lines lines(text);
  for (const std::size_t at : {0U, 1U, 5U, 6U, 7U, 9U, 10U, 11U, 12U})
    EXPECT_EQ(lines.OffsetOf(lines.PositionOf(at)), at);
}

}  // namespace
}  // namespace soarbox::language
