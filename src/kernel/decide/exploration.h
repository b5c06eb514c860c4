// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/random.h"
#include "kernel/decide/preference_semantics.h"

namespace soarbox::kernel {

/// How one of several indifferent operators is selected (`decide indifferent-selection`).
enum class ExplorationPolicy : std::uint8_t {
  kBoltzmann,      ///< Probabilities proportional to exp(value / temperature).
  kEpsilonGreedy,  ///< With probability epsilon any candidate, else one of those with the highest value.
  kSoftmax,        ///< Probabilities proportional to the value, if positive; all equal if no value is.
  kFirst,          ///< The first candidate (PreferenceSemantics::Outcome).
  kLast,           ///< The last candidate.
};

/// How a parameter is reduced after each decide phase while auto-reduce is on.
enum class ReductionPolicy : std::uint8_t { kExponential, kLinear };

/// Epsilon or temperature.
struct ExplorationParameter {
  double value = 0;
  ReductionPolicy reduction = ReductionPolicy::kExponential;
  double exponential_rate = 1;  ///< Multiplied with the value, 0 to 1.
  double linear_rate = 0;       ///< Subtracted, at least 0; the value does not go below 0.

  void Reduce();
};

/// The settings of `decide`. The Set functions refuse values out of range: they return false and change nothing.
struct ExplorationSettings {
  ExplorationPolicy policy = ExplorationPolicy::kSoftmax;
  bool average_numbers = false;  ///< A candidate's value is the mean of its numeric preferences, not their sum.
  bool auto_reduce = false;
  ExplorationParameter epsilon{.value = 0.1};
  ExplorationParameter temperature{.value = 25};

  bool SetEpsilon(double value);      ///< 0 to 1.
  bool SetTemperature(double value);  ///< Above 0.
  static bool SetRate(ExplorationParameter& parameter, ReductionPolicy policy, double rate);
  /// Reduces the parameters. Called once after each decide phase.
  void ReduceAutomatically();
};

/// The value of a candidate for exploration: the sum or mean of its numeric preferences; 0 if there are none.
double NumericValue(const Candidate& candidate, const ExplorationSettings& settings);

/// Selects one of at least two indifferent candidates and returns its index. Draws from `random` exactly as Soar does:
/// one number for softmax and Boltzmann, one or two for epsilon-greedy, none for first and last.
std::size_t Choose(std::span<const Candidate> candidates, const ExplorationSettings& settings, RandomStream& random);

/// The probability of each candidate under the policy, in candidate order.
std::vector<double> SelectionChances(std::span<const Candidate> candidates, const ExplorationSettings& settings);

}  // namespace soarbox::kernel
