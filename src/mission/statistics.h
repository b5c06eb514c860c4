// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace soarbox::mission {

struct Interval {
  double low = 0, high = 0;
};

/// 95 % confidence interval of a rate, after Wilson: `good` of `all` runs. 0 to 1.
Interval WilsonInterval(std::size_t good, std::size_t all);

double Mean(std::span<const double> values);
double Median(std::span<const double> values);
/// Of a sample; 0 for fewer than two values.
double StandardDeviation(std::span<const double> values);
/// 95 % confidence interval of a mean from resampling: the same seed gives the same interval.
Interval BootstrapInterval(std::span<const double> values, std::uint64_t seed = 1);
/// The probability that pairs which differ would be so one-sided by chance (McNemar's exact test, two-sided).
double McNemar(std::size_t only_first, std::size_t only_second);

}  // namespace soarbox::mission
