// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::kernel {

/// Whose value stands for the future when a choice is judged.
enum class RlPolicy : std::uint8_t {
  kSarsa,             ///< The operator that was chosen.
  kQLearning,         ///< The best candidate; traces end where the choice was not the best one.
  kOnPolicyGqLambda,  ///< As kSarsa, with a second set of weights that corrects the gradient.
  kOffPolicyGqLambda  ///< As kQLearning, with corrected gradient and importance ratios.
};

/// What becomes of the learning rate of a rule that is updated often.
enum class RlDecay : std::uint8_t {
  kNormal,        ///< Always `learning_rate`.
  kExponential,   ///< 1 / (updates + 1).
  kLogarithmic,   ///< 1 / (ln(updates + 1) + 1).
  kDeltaBarDelta  ///< Each rule has a rate of its own, which is learned too.
};

/// Which learned rules are forgotten when they are not used.
enum class ApoptosisMode : std::uint8_t {
  kNone,
  kChunks,   ///< Rules of reinforcement learning that were never updated, and all other chunks.
  kRlChunks  ///< Only the former.
};

/// What `rl --set` sets. (`chunk-stop` is AgentSettings::ignore_numbers_of_duplicates.)
struct RlSettings {
  bool learning = false;
  bool temporal_extension = true;  ///< Decisions without such rules are a gap in an episode; else they end it.
  bool temporal_discount = true;   ///< Each decision of a gap discounts once more.
  bool hrl_discount = false;       ///< So does each decision in a substate.
  bool meta = false;               ///< A rule's documentation says how often it was updated, and is read for it.
  bool trace = false;              ///< Choices are kept as a graph (`rl --trace`).
  RlPolicy policy = RlPolicy::kSarsa;
  RlDecay decay = RlDecay::kNormal;
  ApoptosisMode apoptosis = ApoptosisMode::kNone;
  double discount_rate = 0.9;       ///< 0 to 1.
  double learning_rate = 0.3;       ///< 0 to 1.
  double step_size = 1;             ///< Of the second weights, 0 to 1.
  double trace_decay = 0;           ///< Eligibility traces: 0 (none) to 1.
  double trace_tolerance = 0.001;   ///< Traces below are dropped.
  double meta_learning_rate = 0.1;  ///< Of kDeltaBarDelta.
  double apoptosis_decay = 0.5;     ///< How fast a rule's activation falls, 0 to 1.
  double apoptosis_threshold = -2;  ///< The activation below which it is forgotten.
};

}  // namespace soarbox::kernel
