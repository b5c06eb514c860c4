// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/match/match_set.h"

namespace soarbox::kernel {

/// The trace of one positive condition of a match, for learning.
struct ConditionTrace {
  WmeId wme = WmeId::kNone;
  GoalLevel level = 0;    ///< Level of the element's identifier when the rule fired.
  bool inherits = false;  ///< The preference that created the element is of the match's own level. So its fields may
                          ///< have the identities that the creator gave them.
  PreferenceId preference = PreferenceId::kNone;  ///< Creator of the element, at the level of the match, or kNone.
};

/// A fired rule that still matches, or that still has live preferences.
///
/// Instantiations that match only elements of the top state have no condition traces, because nothing is learned from
/// them. Their elements are read from the matcher while the match exists.
struct Instantiation {
  static constexpr std::uint32_t kNoJustification = 0xFFFFFFFFu;

  ProductionId production = ProductionId::kNone;  ///< kNone for instantiations of the architecture.
  MatchId match = MatchId::kNone;                 ///< kNone once it no longer matches.
  Symbol goal;                                    ///< The lowest goal that it matched.
  GoalLevel level = 0;
  bool live = false;
  bool held = false;                          ///< It is being created or asserted: it must not be freed.
  bool o_support = false;                     ///< It fired together with the o-supported rules.
  bool has_identities = false;                ///< It fired in a substate while learning was on.
  std::uint32_t serial = 0;                   ///< Running number; for explanations and learning.
  std::uint32_t backtrace = 0;                ///< The last backtrace that visited it.
  std::uint32_t justification = 0xFFFFFFFFu;  ///< Index of the literal rule that keeps a result alive, or none.
  std::uint32_t first_trace = 0;              ///< Index in the trace arena.
  std::uint32_t selection = 0xFFFFFFFFu;  ///< What selected the local operator that it tests (selection_knowledge.h).
  std::uint32_t first_identity = 0;       ///< First of its own identity numbers, if it has any.
  std::uint16_t trace_count = 0;
  bool in_gds = false;  ///< The elements that it depends on have been added to a goal dependency set. Never reset.
  /// For the own instance of a learned rule or justification (the instantiation that is created when it is learned):
  /// what the reasoning in the substate depended on.
  bool local_negation : 1 = false, long_term_memory : 1 = false;
  bool turned : 1 = false;  ///< Own instance of a learned rule in which some tests have swapped sides
                            ///< (firing_reader.h).
  bool copied : 1 = false;  ///< It copied objects: the elements read for that follow the matched elements in the trace.
  InstantiationId next_free;
  PreferenceId preferences = PreferenceId::kNone;  ///< Newest first: those of the last action come first.
};

}  // namespace soarbox::kernel
