// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace soarbox::mission {

struct Interval {
  double low = 0, high = 0;
};

/// 95 % confidence interval of a rate (Wilson): `good` of `all` runs. 0 to 1.
Interval WilsonInterval(std::size_t good, std::size_t all);

double Mean(std::span<const double> values);
double Median(std::span<const double> values);
/// Standard deviation of a sample; 0 for fewer than two values.
double StandardDeviation(std::span<const double> values);
/// Student's t distribution with `freedom` degrees of freedom: the probability of a value below x (error about 1e-13),
/// and its inverse.
double StudentCdf(double x, std::size_t freedom);
double StudentQuantile(double probability, std::size_t freedom);
/// 95 % confidence interval of a mean (Student). Unlike intervals from resampling, it is valid for few values.
Interval StudentInterval(std::span<const double> values);
/// The probability of a mean at least this far from 0 if the true mean is 0 (Student's t test, two-sided; for
/// differences of pairs, the paired test). Returns 1 for fewer than two values. Equal values other than 0 give 0.
double StudentTest(std::span<const double> differences);
/// Holm's correction for a family of comparisons, in the order of the input. If all quantities are in fact equal, the
/// corrected probabilities show no difference in 95 % of cases.
std::vector<double> Holm(std::span<const double> probabilities);
/// The differences b[i] - a[i]. A difference below the rounding of its two numbers is 0.
std::vector<double> PairedDifferences(std::span<const double> a, std::span<const double> b);
/// Mean of the differences of pairs divided by their standard deviation (Cohen's d for pairs). 0 if all differences are
/// 0; nothing if they are equal to each other, except for rounding, and not 0.
std::optional<double> PairedEffect(std::span<const double> a, std::span<const double> b);
/// Cliff's delta: the probability that a value of b is above one of a, minus the probability that it is below; -1 to 1.
double CliffsDelta(std::span<const double> a, std::span<const double> b);
/// The number of pairs with which a difference of `effect` standard deviations is detected in 80 % of cases (two-sided,
/// 5 %). 0: no number is sufficient.
std::size_t PairsFor(double effect);

/// The probability that differing pairs are this one-sided by chance (McNemar's exact test, two-sided).
double McNemar(std::size_t only_first, std::size_t only_second);

}  // namespace soarbox::mission
