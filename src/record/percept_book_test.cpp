// SPDX-License-Identifier: BSD-2-Clause
#include "record/percept_book.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <string>

namespace soarbox::record {
namespace {

TEST(TextBook, FindsEachTextByItsBytes) {
  TextBook book;
  const auto find = [&](std::string_view text) { return book.Find(text, TextBook::Hash(text)); };
  for (int round = 0; round < 2; ++round) {
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const std::string text = "path" + std::to_string(i * 7919);
      EXPECT_FALSE(find(text));
      EXPECT_EQ(book.AddFindable(text, TextBook::Hash(text)), i);
    }
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(find("path" + std::to_string(i * 7919)), i);
    EXPECT_FALSE(find(""));
    EXPECT_EQ(book.At(1), "path7919");
    book.Clear();
    EXPECT_EQ(book.size(), 0u);
    EXPECT_FALSE(find("path0"));
  }
}

TEST(PairTable, FindsNumbersByPairs) {
  PairTable table;
  EXPECT_FALSE(table.Find(0, 0));
  for (std::uint32_t a = 0; a < 30; ++a)
    for (std::uint32_t b = 0; b < 50; ++b) table.Add(a, b, a * 1000 + b);
  for (std::uint32_t a = 0; a < 30; ++a)
    for (std::uint32_t b = 0; b < 50; ++b) EXPECT_EQ(table.Find(a, b), a * 1000 + b);
  EXPECT_FALSE(table.Find(30, 0));
  table.Clear();
  EXPECT_FALSE(table.Find(0, 0));
}

/// The bytes of the integer 5, as logs store it, with numbers of one or two groups.
TEST(PerceptValue, AValueThatIsNotInItsOnlyFormIsRefused) {
  LastValue last;
  ShortWriter out;
  EXPECT_EQ(WriteValue(out, std::string("\x01\x0a", 2), last), Stored::kCompletely);
  EXPECT_EQ(last.number, 5);
  const std::size_t written = out.bytes().size();
  for (const std::string& wrong :
       {std::string(), std::string("\x01\x8a\x00", 3), std::string("\x01"), std::string("\x01\x0a\x00", 3),
        std::string("\x00\x81\x00x", 4), std::string("\x00\x02x", 3), std::string("\x02\x00\x00", 3),
        std::string("\x04\x00", 2)})
    EXPECT_EQ(WriteValue(out, wrong, last), Stored::kNot) << wrong.size();
  EXPECT_EQ(out.bytes().size(), written);
}

TEST(PerceptValue, AnyBitsOfFloatsAndDoublesAreReadBack) {
  std::mt19937_64 random(1);
  LastValue wrote, read;
  for (int i = 0; i < 20'000; ++i) {
    std::string value;
    ByteWriter out(value);
    const bool is_float = random() % 2 == 0;
    out.Byte(is_float ? 2 : 3);
    const double number = static_cast<double>(random() % 5000) / 100 - 10;
    if (is_float) {
      out.Fixed32(random() % 3 == 0 ? static_cast<std::uint32_t>(random())
                                    : std::bit_cast<std::uint32_t>(static_cast<float>(number)));
    } else {
      out.Fixed64(random() % 3 == 0 ? random() : std::bit_cast<std::uint64_t>(number));
    }
    ShortWriter written;
    ASSERT_EQ(WriteValue(written, value, wrote), Stored::kCompletely);
    ASSERT_LE(written.bytes().size(), kMostOfValue);
    ByteReader in(written.bytes());
    std::string again;
    ReadValue(in, read, again);
    ASSERT_FALSE(in.failed());
    ASSERT_EQ(again, value) << i;
  }
}

}  // namespace
}  // namespace soarbox::record
