// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/random.h"
#include "kernel/decide/preference_semantics.h"

namespace soarbox::kernel {

/// How one of several indifferent operators is chosen (`decide indifferent-selection`).
enum class ExplorationPolicy : std::uint8_t {
  kBoltzmann,      ///< Chances in proportion to exp(value / temperature).
  kEpsilonGreedy,  ///< With chance epsilon any, else one of those with the highest value.
  kSoftmax,        ///< Chances in proportion to the value, if positive; all equal if none is.
  kFirst,          ///< The candidate that was proposed last.
  kLast,           ///< The candidate that was proposed first.
};

/// How a parameter shrinks after each decide phase when auto-reduce is on.
enum class ReductionPolicy : std::uint8_t { kExponential, kLinear };

/// Epsilon or temperature.
struct ExplorationParameter {
  double value = 0;
  ReductionPolicy reduction = ReductionPolicy::kExponential;
  double exponential_rate = 1;  ///< A factor, 0 to 1.
  double linear_rate = 0;       ///< Subtracted, at least 0; the value does not go below 0.

  void Reduce();
};

/// What `decide` sets. The Set functions refuse values out of range: false, and nothing changes.
struct ExplorationSettings {
  ExplorationPolicy policy = ExplorationPolicy::kSoftmax;
  bool average_numbers = false;  ///< A candidate's numeric preferences count by their mean, else by their sum.
  bool auto_reduce = false;
  ExplorationParameter epsilon{.value = 0.1};
  ExplorationParameter temperature{.value = 25};

  bool SetEpsilon(double value);      ///< 0 to 1.
  bool SetTemperature(double value);  ///< Above 0.
  static bool SetRate(ExplorationParameter& parameter, ReductionPolicy policy, double rate);
  /// Called once after each decide phase.
  void ReduceAutomatically();
};

/// The value of a candidate for exploration: the sum or mean of its numeric preferences, 0 without any.
double NumericValue(const Candidate& candidate, const ExplorationSettings& settings);

/// Chooses one of at least two indifferent candidates; returns its index. Draws from `random` exactly as Soar does: one
/// number for softmax and Boltzmann, one or two for epsilon-greedy, none for first and last.
std::size_t Choose(std::span<const Candidate> candidates, const ExplorationSettings& settings, RandomStream& random);

/// The chance of each candidate under the policy, 0 to 1, in candidate order.
std::vector<double> SelectionChances(std::span<const Candidate> candidates, const ExplorationSettings& settings);

}  // namespace soarbox::kernel
