// SPDX-License-Identifier: BSD-2-Clause
#include "mission/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace soarbox::mission {
namespace {

TEST(Statistics, TheIntervalOfARateIsWilsons) {
  // The roots of (p - rate)^2 = z^2 p (1 - p) / n, solved by hand.
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
  // Twice the fraction of the binomial coefficients up to the smaller number.
  EXPECT_NEAR(McNemar(0, 5), 2 / 32.0, 1e-12);
  EXPECT_NEAR(McNemar(3, 9), 2 * (1 + 12 + 66 + 220) / 4096.0, 1e-12);
  EXPECT_NEAR(McNemar(30, 60), 0.00206026568096, 1e-12);
  EXPECT_EQ(McNemar(10, 10), 1);
  EXPECT_EQ(McNemar(0, 0), 1);
}

TEST(Statistics, FewValuesGiveNoFalsePrecision) {
  EXPECT_EQ(StudentInterval({}).low, 0);
  const std::array<double, 1> one = {4};
  EXPECT_EQ(StudentInterval(one).low, 4);
  EXPECT_EQ(Median(std::array<double, 4>{4, 1, 3, 2}), 2.5);
  EXPECT_NEAR(StandardDeviation(std::array<double, 4>{1, 2, 3, 4}), 1.2909944487, 1e-9);
}

TEST(Statistics, StudentsTIsThatOfTheTables) {
  // Two-sided 5 % points of printed tables. With one degree of freedom it is a tangent, with two a root.
  EXPECT_NEAR(StudentQuantile(0.975, 1), 12.7062047362, 1e-8);
  EXPECT_NEAR(StudentQuantile(0.975, 2), 4.3026527297, 1e-8);
  EXPECT_NEAR(StudentQuantile(0.975, 9), 2.262, 5e-4);
  EXPECT_NEAR(StudentQuantile(0.975, 24), 2.064, 5e-4);
  EXPECT_NEAR(StudentQuantile(0.975, 120), 1.980, 5e-4);
  EXPECT_NEAR(StudentCdf(1, 1), 0.75, 1e-12);
  EXPECT_NEAR(StudentCdf(-1, 1), 0.25, 1e-12);
  EXPECT_NEAR(StudentCdf(1.5, 2), 0.5 + 1.5 / (2 * std::sqrt(2 + 1.5 * 1.5)), 1e-12);
  EXPECT_EQ(StudentCdf(0, 7), 0.5);
  const std::array<double, 5> five = {1, 2, 3, 4, 5};
  EXPECT_NEAR(StudentInterval(five).low, 3 - 2.776 * std::sqrt(0.5), 5e-4);
  EXPECT_NEAR(StudentInterval(five).high, 3 + 2.776 * std::sqrt(0.5), 5e-4);
  // With two degrees of freedom the probability has a closed form: t = 2 sqrt(3).
  const std::array<double, 3> three = {1, 2, 3};
  EXPECT_NEAR(StudentTest(three), 1 - std::sqrt(12.0 / 14), 1e-12);
  EXPECT_EQ(StudentTest(std::array<double, 1>{3}), 1);
  EXPECT_EQ(StudentTest(std::array<double, 3>{0, 0, 0}), 1);
}

TEST(Statistics, FewValuesKeepTheFivePercent) {
  // The mean of twelve uniform numbers minus 6 is 0. Counts how often an interval excludes it; the tolerance is four
  // standard errors.
  std::mt19937_64 random(11);
  constexpr int kSamples = 4000;
  for (const std::size_t size : {3u, 5u, 10u, 25u}) {
    int excluded = 0;
    for (int sample = 0; sample < kSamples; ++sample) {
      std::vector<double> values(size, -6);
      for (double& value : values)
        for (int i = 0; i < 12; ++i) value += static_cast<double>(random() >> 11) * 0x1p-53;
      const Interval interval = StudentInterval(values);
      const bool is_excluded = interval.low > 0 || interval.high < 0;
      EXPECT_EQ(is_excluded, StudentTest(values) < 0.05);
      excluded += is_excluded ? 1 : 0;
    }
    RecordProperty("n" + std::to_string(size), excluded);
    EXPECT_NEAR(static_cast<double>(excluded) / kSamples, 0.05, 0.0138) << size << " values";
  }
}

TEST(Statistics, HolmCorrectsAFamily) {
  const std::array<double, 4> family = {0.01, 0.04, 0.03, 0.005};
  const std::vector<double> corrected = Holm(family);
  const std::array<double, 4> by_hand = {0.03, 0.06, 0.06, 0.02};
  ASSERT_EQ(corrected.size(), by_hand.size());
  for (std::size_t i = 0; i < by_hand.size(); ++i) EXPECT_NEAR(corrected[i], by_hand[i], 1e-12);
  EXPECT_EQ(Holm(std::array<double, 2>{0.9, 0.8}), (std::vector<double>{1, 1}));
  EXPECT_TRUE(Holm({}).empty());
}

TEST(Statistics, EffectsAreThoseOfAllPairs) {
  const std::array<double, 4> a = {1, 2, 2, 5}, b = {2, 3, 5, 6};
  int sum = 0;
  for (const double one : a)
    for (const double other : b) sum += other > one ? 1 : other < one ? -1 : 0;
  EXPECT_DOUBLE_EQ(CliffsDelta(a, b), sum / 16.0);
  EXPECT_EQ(CliffsDelta(a, a), 0);
  EXPECT_EQ(CliffsDelta(a, std::array<double, 1>{9}), 1);
  EXPECT_NEAR(PairedEffect(a, std::array<double, 4>{2, 4, 5, 9}).value(), 2.5 / std::sqrt(5.0 / 3), 1e-12);
}

TEST(Statistics, EqualDifferencesHaveNoEffectSize) {
  // 0.3 - 0.1 and 0.9 - 0.7 differ in their last bits.
  const std::array<double, 3> a = {0.1, 0.7, 1.1}, b = {0.3, 0.9, 1.3};
  EXPECT_EQ(PairedEffect(a, b), std::nullopt);
  EXPECT_EQ(PairedEffect(std::array<double, 2>{1, 2}, std::array<double, 2>{4, 5}), std::nullopt);
  EXPECT_EQ(PairedEffect(a, a), 0);
}

TEST(Statistics, DifferencesBelowTheRoundingAreZero) {
  const std::array<double, 2> a = {0.3, 1e6}, b = {0.1 + 0.2, 1e6 + 1e-4};
  EXPECT_EQ(PairedDifferences(a, b), (std::vector<double>{0, 0}));
  EXPECT_EQ(PairedEffect(a, b), 0);
  EXPECT_EQ(PairedDifferences(std::array<double, 1>{1}, std::array<double, 1>{1.5}), std::vector<double>{0.5});
}

TEST(Statistics, SmallerEffectsNeedMorePairs) {
  // The exact numbers of the noncentral t distribution.
  EXPECT_EQ(PairsFor(0.5), 34u);
  EXPECT_EQ(PairsFor(-0.2), 199u);
  EXPECT_EQ(PairsFor(0.1), 787u);
  EXPECT_EQ(PairsFor(0), 0u);
}

}  // namespace
}  // namespace soarbox::mission
