// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/base/forkable_room.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "kernel/base/plain_vector.h"

namespace soarbox::kernel {
namespace {

using Numbers = PlainVector<std::uint32_t, ForkableRoom>;

Numbers Ascending(std::size_t count) {
  Numbers numbers;
  numbers.resize(count);
  for (std::uint32_t n = 0; n < count; ++n) numbers[n] = n;
  return numbers;
}

void MakeImage(const Numbers& numbers) {
  numbers.room().MakeImage(numbers.data(), numbers.size() * sizeof(std::uint32_t));
}

TEST(ForkableRoom, CopiesHoldWhatTheOriginalHeldAndChangeForThemselves) {
  for (const std::size_t count : {0u, 10u, 20'000u}) {
    Numbers original = Ascending(count);
    MakeImage(original);
    Numbers first(original);
    const Numbers second(original);
    EXPECT_EQ(first, original);
    if (count != 0) first[count / 2] = 7'000'000;
    first.emplace_back() = 8'000'000;
    EXPECT_EQ(first[count], 8'000'000u);
    EXPECT_EQ(original, Ascending(count));
    EXPECT_EQ(second, original);
  }
}

TEST(ForkableRoom, ACopyGrowsAndKeepsWhatItHas) {
  auto original = std::make_unique<Numbers>(Ascending(20'000));
  MakeImage(*original);
  Numbers copy(*original);
  original.reset();  // The shared pages of the copies stay valid.
  for (std::uint32_t n = 0; n < 20'000; n += 1000) copy[n] = ~n;
  for (std::uint32_t n = 20'000; n < 200'000; ++n) copy.emplace_back() = n;
  ASSERT_EQ(copy.size(), 200'000u);
  for (std::uint32_t n = 0; n < 200'000; ++n) ASSERT_EQ(copy[n], n < 20'000 && n % 1000 == 0 ? ~n : n);
  const Numbers of_copy(copy);
  EXPECT_EQ(of_copy, copy);
  const Numbers moved(std::move(copy));
  EXPECT_EQ(moved, of_copy);
}

TEST(ForkableRoom, AForgottenImageIsNotCopied) {
  Numbers original = Ascending(20'000);
  MakeImage(original);
  original.room().ForgetImage();
  original[3] = 4;
  EXPECT_EQ(Numbers(original)[3], 4u);
}

TEST(ForkableRoom, MoreCopiesThanMayBeMappedAreMadeInFull) {
  const Numbers original = Ascending(8'200);
  MakeImage(original);
  std::vector<Numbers> copies(9'000, original);
  for (std::uint32_t n = 0; n < copies.size(); ++n) copies[n][0] = n;
  for (std::uint32_t n = 0; n < copies.size(); ++n) {
    ASSERT_EQ(copies[n][0], n);
    ASSERT_EQ(copies[n][8'199], 8'199u);
  }
}

}  // namespace
}  // namespace soarbox::kernel
