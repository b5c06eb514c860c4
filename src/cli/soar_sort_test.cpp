// SPDX-License-Identifier: BSD-2-Clause
#include "cli/soar_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace soarbox::cli {
namespace {

using Line = std::pair<std::size_t, std::size_t>;  ///< Its count, and its place before sorting.

constexpr auto kByCount = [](const Line& a, const Line& b) { return a.first < b.first; };

/// Hash of the order.
std::uint64_t HashOf(const std::vector<Line>& lines) {
  std::uint64_t hash = 1469598103934665603u;
  for (const Line& line : lines) hash = (hash ^ line.second) * 1099511628211u;
  return hash;
}

/// Sequences that make each median of three a bad pivot, so that the heap sort takes over.
std::vector<Line> BadPivots(std::size_t half) {
  std::vector<Line> lines(2 * half);
  for (std::size_t i = 1; i <= half; ++i) {
    if (i % 2 == 1) {
      lines[i - 1].first = i;
      lines[i].first = half + i;
    }
    lines[half + i - 1].first = 2 * i;
  }
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].second = i;
  return lines;
}

TEST(SoarSort, ShortListsKeepTheOrderOfEqualElements) {
  std::vector<Line> lines{{1, 0}, {0, 1}, {1, 2}, {0, 3}};
  SortLikeSoar(lines, kByCount);
  EXPECT_EQ(lines, (std::vector<Line>{{0, 1}, {0, 3}, {1, 0}, {1, 2}}));
  std::vector<Line> none;
  SortLikeSoar(none, kByCount);
  EXPECT_TRUE(none.empty());
}

// On every platform; the hashes are those of GCC's library.
TEST(SoarSort, EqualElementsOfLongListsAreInTheOrderOfGccsLibrary) {
  std::mt19937 random(1);
  std::uint64_t hash = 0;
  for (std::size_t round = 0; round < 2000; ++round) {
    std::vector<Line> lines = round % 10 == 0 ? BadPivots(20 + round) : std::vector<Line>(random() % 200);
    const std::size_t counts = 1 + random() % (round % 2 == 0 ? 3 : 100);
    if (round % 10 != 0) {
      for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = {random() % counts, i};
    }
    [[maybe_unused]] std::vector<Line> expected = lines;
    SortLikeSoar(lines, kByCount);
#ifdef __GLIBCXX__
    std::sort(expected.begin(), expected.end(), kByCount);
    ASSERT_EQ(lines, expected) << "round " << round;
#endif
    hash = hash * 31 + HashOf(lines);
  }
  EXPECT_EQ(hash, 11168590652645446977u);
}

}  // namespace
}  // namespace soarbox::cli
