// SPDX-License-Identifier: BSD-2-Clause
#include "mission/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace soarbox::mission {
namespace {

TEST(Statistics, TheIntervalOfARateIsWilsons) {
  // The roots of (p - rate)^2 = z^2 p (1 - p) / n, solved for by hand.
  const Interval most = WilsonInterval(18, 20);
  EXPECT_NEAR(most.low, 0.698966355, 1e-8);
  EXPECT_NEAR(most.high, 0.972133519, 1e-8);
  const Interval few = WilsonInterval(1, 3);
  EXPECT_NEAR(few.low, 0.061491945, 1e-8);
  EXPECT_NEAR(few.high, 0.792340399, 1e-8);
  EXPECT_NEAR(WilsonInterval(20, 20).low, 0.838874842, 1e-8);
  EXPECT_EQ(WilsonInterval(20, 20).high, 1);
  EXPECT_EQ(WilsonInterval(0, 10).low, 0);
  EXPECT_NEAR(WilsonInterval(0, 10).high, 0.2775328, 1e-7);
  EXPECT_EQ(WilsonInterval(0, 0).high, 1) << "nothing is known";
}

TEST(Statistics, PairsThatDifferAreComparedWithAFairCoin) {
  // Twice the share of the binomial coefficients up to the smaller number.
  EXPECT_NEAR(McNemar(0, 5), 2 / 32.0, 1e-12);
  EXPECT_NEAR(McNemar(3, 9), 2 * (1 + 12 + 66 + 220) / 4096.0, 1e-12);
  EXPECT_NEAR(McNemar(30, 60), 0.00206026568096, 1e-12);
  EXPECT_EQ(McNemar(10, 10), 1);
  EXPECT_EQ(McNemar(0, 0), 1);
}

TEST(Statistics, TheIntervalOfAMeanIsWhatOtherImplementationsOfTheBootstrapCompute) {
  // SciPy's bootstrap with method BCa and 100,000 resamples gives these. Many resamples have the same mean here.
  const std::array<double, 10> even = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_NEAR(BootstrapInterval(even).low, 3.7, 0.11);
  EXPECT_NEAR(BootstrapInterval(even).high, 7.3, 0.11);
  const std::array<double, 12> rate = {0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0};
  EXPECT_NEAR(BootstrapInterval(rate).low, 0.0833, 0.001);
  EXPECT_NEAR(BootstrapInterval(rate).high, 0.5833, 0.001);
  const std::array<double, 8> skewed = {0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.4, 12.8};
  EXPECT_NEAR(BootstrapInterval(skewed).low, 1.15, 0.1);
  EXPECT_NEAR(BootstrapInterval(skewed).high, 7.6, 0.25);
}

TEST(Statistics, TheIntervalHoldsTheTrueMeanAboutAsOftenAsItSays) {
  std::mt19937_64 random(7);
  int held = 0;
  constexpr int kSamples = 150;
  for (int sample = 0; sample < kSamples; ++sample) {
    std::vector<double> values(40);
    // The sum of twelve even numbers is close to normal; their mean is 6.
    for (double& value : values)
      for (int i = 0; i < 12; ++i) value += static_cast<double>(random() >> 11) * 0x1p-53;
    const Interval interval = BootstrapInterval(values, static_cast<std::uint64_t>(sample) + 1);
    held += interval.low <= 6 && 6 <= interval.high ? 1 : 0;
  }
  EXPECT_GE(held, kSamples * 88 / 100);
  EXPECT_LT(held, kSamples);
}

TEST(Statistics, FewValuesGiveNoFalsePrecision) {
  EXPECT_EQ(BootstrapInterval({}).low, 0);
  const std::array<double, 1> one = {4};
  EXPECT_EQ(BootstrapInterval(one).low, 4);
  EXPECT_EQ(Median(std::array<double, 4>{4, 1, 3, 2}), 2.5);
  EXPECT_NEAR(StandardDeviation(std::array<double, 4>{1, 2, 3, 4}), 1.2909944487, 1e-9);
}

}  // namespace
}  // namespace soarbox::mission
