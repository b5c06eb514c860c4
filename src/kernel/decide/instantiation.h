// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/match/match_set.h"

namespace soarbox::kernel {

/// What one positive condition of a match tested: what learning follows.
struct ConditionTrace {
  WmeId wme = WmeId::kNone;
  GoalLevel level = 0;    ///< Of the element's identifier when the rule fired.
  bool inherits = false;  ///< The element is of the match's level only: no learned rule holds it at a higher one.
  PreferenceId preference = PreferenceId::kNone;  ///< That made the element, at the level of the match; or kNone.
};

/// A rule that fired on one match and still matches, or has preferences that live.
///
/// Matches that touch only the top state keep no condition traces (nothing above could learn from them): their elements
/// are read from the matcher while the match exists.
struct Instantiation {
  static constexpr std::uint32_t kNoJustification = 0xFFFFFFFFu;

  ProductionId production = ProductionId::kNone;  ///< kNone for the architecture's own.
  MatchId match = MatchId::kNone;                 ///< kNone once it no longer matches.
  Symbol goal;                                    ///< The lowest goal that it matched.
  GoalLevel level = 0;
  bool live = false;
  bool held = false;                          ///< It is being made or asserted: not to be freed yet.
  bool o_support = false;                     ///< It fired with the o-supported rules.
  bool has_identities = false;                ///< It fired in a substate while learning was on.
  std::uint32_t serial = 0;                   ///< Counts instantiations; for explanations and learning.
  std::uint32_t backtrace = 0;                ///< The last backtrace that visited it.
  std::uint32_t justification = 0xFFFFFFFFu;  ///< Index of the literal rule that keeps a result, or none.
  std::uint32_t first_trace = 0;              ///< In the trace arena.
  std::uint32_t selection = 0xFFFFFFFFu;  ///< What decided the local operator that it tests (selection_knowledge.h).
  std::uint32_t first_identity = 0;       ///< The number of its first identity of its own, if it has some.
  std::uint16_t trace_count = 0;
  bool in_gds = false;  ///< What it rests on has been taken into a goal's dependency set: once and for all.
  /// Of a learned rule's or a justification's own instance: what the reasoning in the substate rested on.
  bool local_negation : 1 = false, long_term_memory : 1 = false;
  bool turned : 1 = false;  ///< A learned rule's own instance some of whose tests were turned round (firing_reader.h).
  bool copied : 1 = false;  ///< It copied objects: what it read for that stands behind what the conditions matched.
  InstantiationId next_free;
  PreferenceId preferences = PreferenceId::kNone;  ///< Newest first: the last action comes first.
};

}  // namespace soarbox::kernel
