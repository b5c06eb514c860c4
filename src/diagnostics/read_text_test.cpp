// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/read_text.h"

#include <gtest/gtest.h>

#include <fstream>

namespace soarbox {
namespace {

TEST(ReadText, GivesEachByteOfAFileAndNothingOfWhatIsNone) {
  const std::filesystem::path folder = testing::TempDir();
  const std::filesystem::path file = folder / "soarbox-read-text";
  std::string text(40'000, 'x');
  text[20'000] = '\0';
  text += "\r\n";
  std::ofstream(file, std::ios::binary) << text;
  EXPECT_EQ(ReadText(file), text);
  std::ofstream(file, std::ios::binary | std::ios::trunc).close();
  EXPECT_EQ(ReadText(file), "") << "an empty file is a file";
  std::filesystem::remove(file);
  EXPECT_FALSE(ReadText(file));
  EXPECT_FALSE(ReadText(folder));
}

}  // namespace
}  // namespace soarbox
