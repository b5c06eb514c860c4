// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::kernel {

/// Which operator's value an update uses as the expected future.
enum class RlPolicy : std::uint8_t {
  kSarsa,             ///< The selected operator.
  kQLearning,         ///< The best candidate. Traces are cleared if the selected operator was not the best one.
  kOnPolicyGqLambda,  ///< Like kSarsa, with a second set of weights that corrects the gradient.
  kOffPolicyGqLambda  ///< Like kQLearning, with corrected gradient and importance ratios.
};

/// How the learning rate of a rule depends on its number of updates.
enum class RlDecay : std::uint8_t {
  kNormal,        ///< Always `learning_rate`.
  kExponential,   ///< 1 / (updates + 1).
  kLogarithmic,   ///< 1 / (ln(updates + 1) + 1).
  kDeltaBarDelta  ///< Each rule has its own rate, which is learned, too.
};

/// Which learned rules are removed if they are not used.
enum class ApoptosisMode : std::uint8_t {
  kNone,
  kChunks,   ///< Rules of reinforcement learning that were never updated, and all other chunks.
  kRlChunks  ///< Only rules of reinforcement learning that were never updated.
};

/// The settings of `rl --set`. (`chunk-stop` is AgentSettings::ignore_numbers_of_duplicates.)
struct RlSettings {
  bool learning = false;
  bool temporal_extension = true;  ///< Decisions without learning rules are a gap in an episode; if false, they end it.
  bool temporal_discount = true;   ///< The discount applies once per decision of a gap.
  bool hrl_discount = false;       ///< The discount applies once per decision in a substate.
  bool meta = false;  ///< A rule's documentation contains its number of updates, which is read when the rule is loaded.
  bool trace = false;  ///< Choices are recorded as a graph (`rl --trace`).
  RlPolicy policy = RlPolicy::kSarsa;
  RlDecay decay = RlDecay::kNormal;
  ApoptosisMode apoptosis = ApoptosisMode::kNone;
  double discount_rate = 0.9;       ///< 0 to 1.
  double learning_rate = 0.3;       ///< 0 to 1.
  double step_size = 1;             ///< Step size of the second weights, 0 to 1.
  double trace_decay = 0;           ///< Eligibility traces: 0 (none) to 1.
  double trace_tolerance = 0.001;   ///< Traces below this value are dropped.
  double meta_learning_rate = 0.1;  ///< For kDeltaBarDelta.
  double apoptosis_decay = 0.5;     ///< Decay rate of a rule's activation, 0 to 1.
  double apoptosis_threshold = -2;  ///< Rules with a lower activation are removed.
};

}  // namespace soarbox::kernel
