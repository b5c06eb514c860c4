// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/bump_arena.h"
#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/rules/draft.h"

namespace soarbox::kernel {

/// Why a substate made its results, as learning found out: what was tested where, and who made it. Valid while the
/// result is analysed; the stages of learning fill it in and read it one after the other.
struct Explanation {
  GoalLevel level = 0;  ///< Of the substate.
  InstantiationId base = InstantiationId::kNone;

  // Results (results.h) -----------------------------------------------------------------------------------------------

  /// All that the firing gave to higher states, with the substructure that comes along; newest first.
  std::vector<PreferenceId> results;
  /// The identifier of one result is the value (or referent) of another.
  struct Child {
    PreferenceId child, parent;
    bool by_referent = false;
  };
  std::vector<Child> children;

  // What they rest on (backtrace.h) -----------------------------------------------------------------------------------

  std::vector<InstantiationId> firings;  ///< In the order in which they were visited.
  /// A condition that tested an element of a higher state, or an item of the impasse (no condition), which rests on a
  /// proposal of a higher state.
  struct Ground {
    InstantiationId firing = InstantiationId::kNone;
    std::uint16_t condition = 0;
    WmeId wme = WmeId::kNone;
    WmeId item = WmeId::kNone;
  };
  std::vector<Ground> grounds;  ///< The one found last comes first.
  /// A condition that tested an element of the substate, and the preference that made it.
  struct Link {
    InstantiationId firing = InstantiationId::kNone;
    std::uint16_t condition = 0;
    PreferenceId maker = PreferenceId::kNone;
  };
  std::vector<Link> links;  ///< In the order in which they were followed.
  /// Conditions that tested the substate's superstate link, or an item.
  std::vector<Link> superstate_links;
  struct ItemTest {
    InstantiationId firing = InstantiationId::kNone;
    std::uint16_t condition = 0;
    WmeId item = WmeId::kNone;
  };
  std::vector<ItemTest> item_tests;
  std::vector<WmeId> items;  ///< Items of the impasse that were followed to the proposals that they rest on.
  /// A negated condition that refers to higher states only. `source` is none in justifications; `classes` are the
  /// classes of what their tests name, or none.
  struct Negation {
    InstantiationId firing = InstantiationId::kNone;
    const Condition* source = nullptr;
    ConditionDraft literal;
    std::span<const std::uint16_t> classes;
  };
  std::vector<Negation> negations;  ///< The one found last comes first.
  GoalLevel lowest_ground = 0;      ///< Of the states that grounds hang on; 0 if none hangs on a state.
  std::vector<WmeId> operator_grounds;
  bool quiescence = false, local_negation = false, long_term_memory = false;

  Arena drafts;  ///< Of the negations.
  std::uint32_t trace_number = 0;
};

}  // namespace soarbox::kernel
