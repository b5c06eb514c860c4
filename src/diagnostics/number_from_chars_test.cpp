// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/number_from_chars.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace soarbox {
namespace {

/// The results on which both functions must agree.
struct Reading {
  std::ptrdiff_t length;
  std::errc error;
  std::uint64_t bits;

  bool operator==(const Reading&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Reading& reading) {
  return out << reading.length << " letters, error " << static_cast<int>(reading.error) << ", bits " << reading.bits;
}

template <typename Number>
Reading ReadingOf(std::string_view text, const std::from_chars_result& result, Number value) {
  // The bits of NaN depend on the library.
  const double wide = std::isnan(value) ? 0.5 : static_cast<double>(value);
  return {result.ptr - text.data(), result.ec, std::bit_cast<std::uint64_t>(wide)};
}

void ExpectTheSame(std::string_view text) {
  for (const std::chars_format format : {std::chars_format::general, std::chars_format::hex}) {
    double one = 7, other = 7;
    const auto library = std::from_chars(text.data(), text.data() + text.size(), one, format);
    const auto ours = NumberByStrtod(text, other, format);
    EXPECT_EQ(ReadingOf(text, library, one), ReadingOf(text, ours, other))
        << "'" << text << "'" << (format == std::chars_format::hex ? " in hexadecimal" : "");
  }
  float one = 7, other = 7;
  const auto library = std::from_chars(text.data(), text.data() + text.size(), one);
  const auto ours = NumberByStrtod(text, other);
  EXPECT_EQ(ReadingOf(text, library, one), ReadingOf(text, ours, other)) << "'" << text << "' as float";
}

TEST(NumberFromChars, StrtodReadsWhatTheLibraryReads) {
  for (const char* text : {"",
                           "-",
                           "+1",
                           " 1",
                           "1",
                           "-1",
                           "1 ",
                           "0",
                           "-0",
                           "0.1",
                           ".5",
                           "-.5",
                           "5.",
                           ".",
                           "-.",
                           "1e5",
                           "1E-5",
                           "1e+5",
                           "1e",
                           "1e+",
                           "1e-x",
                           "1.5.2",
                           "0x10",
                           "1f",
                           "ff",
                           "FF.8",
                           "1p4",
                           "1.8p-3",
                           "1p",
                           "inf",
                           "-INF",
                           "infinity",
                           "infinit",
                           "nan",
                           "-nan",
                           "NaN(1_a)",
                           "nan(",
                           "nan(+)",
                           "in",
                           "e5",
                           "1e308",
                           "1.7976931348623157e308",
                           "1.8e308",
                           "-1e309",
                           "1e400",
                           "5e-324",
                           "4.9e-324",
                           "2e-324",
                           "1e-400",
                           "2.2250738585072011e-308",
                           "3.4028235e38",
                           "3.5e38",
                           "1e-45",
                           "1e-50",
                           "0e999",
                           "0.000e-999",
                           "9007199254740993",
                           "59026050719272.0625",
                           "1e99999999999",
                           "1e-99999999999",
                           "0.1000000000000000055511151231257827021181583404541015625",
                           "1,5",
                           "1_000"})
    ExpectTheSame(text);
}

TEST(NumberFromChars, StrtodReadsWhatTheLibraryReadsInTextsMadeByChance) {
  std::mt19937 random(1);
  const std::string letters = "0123456789..eE+--pafnix( ";
  for (int i = 0; i < 200'000; ++i) {
    std::string text;
    for (std::uint32_t length = random() % 12; length > 0; --length) text += letters[random() % letters.size()];
    // libstdc++ 12 accepts the hexadecimal 1p+-2 as a number.
    if (text.find("+-") == std::string::npos) ExpectTheSame(text);
  }
}

TEST(NumberFromChars, TheValueStaysAfterAnError) {
  double value = 7;
  EXPECT_EQ(NumberFromChars("1e999", value).ec, std::errc::result_out_of_range);
  EXPECT_EQ(NumberFromChars("x", value).ec, std::errc::invalid_argument);
  EXPECT_EQ(value, 7);
}

TEST(NumberFromChars, ReadsWholeNumbersToo) {
  int whole = 0;
  const std::string_view text = "42 and more";
  EXPECT_EQ(NumberFromChars(text, whole).ptr, text.data() + 2);
  EXPECT_EQ(whole, 42);
}

}  // namespace
}  // namespace soarbox
