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

/// The analysis of a substate's results: which elements were tested, and what created them. Valid while the results are
/// analysed. The stages of learning fill it in and read it in turn.
struct Explanation {
  GoalLevel level = 0;  ///< Level of the substate.
  InstantiationId base = InstantiationId::kNone;

  // Results (results.h) -----------------------------------------------------------------------------------------------

  /// All results of the firing, including the substructure that becomes reachable from higher states; newest first.
  std::vector<PreferenceId> results;
  /// The identifier of one result is the value (or referent) of another result.
  struct Child {
    PreferenceId child, parent;
    bool by_referent = false;
  };
  std::vector<Child> children;

  // The causes of the results (backtrace.h) ---------------------------------------------------------------------------

  std::vector<InstantiationId> firings;  ///< In the order in which they were visited.
  /// A condition that tested an element of a higher state. Or, without a condition, an item of the impasse, which
  /// depends on a proposal in a higher state.
  struct Ground {
    InstantiationId firing = InstantiationId::kNone;
    std::uint16_t condition = 0;
    WmeId wme = WmeId::kNone;
    WmeId item = WmeId::kNone;
  };
  std::vector<Ground> grounds;  ///< The one found last is first.
  /// A condition that tested an element of the substate, and the preference that created the element.
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
  std::vector<WmeId> items;  ///< Items of the impasse that were followed to the proposals that caused them.
  /// A negated condition that refers only to higher states. `source` is none in justifications. `classes` are the
  /// classes of its referents, or empty.
  struct Negation {
    InstantiationId firing = InstantiationId::kNone;
    const Condition* source = nullptr;
    ConditionDraft literal;
    std::span<const std::uint16_t> classes;
  };
  std::vector<Negation> negations;  ///< The one found last is first.
  GoalLevel lowest_ground = 0;      ///< Level of the lowest state that the grounds belong to; 0 if they belong to none.
  std::vector<WmeId> operator_grounds;
  bool quiescence = false, local_negation = false, long_term_memory = false;

  Arena drafts;  ///< Memory of the negations.
  std::uint32_t trace_number = 0;
};

}  // namespace soarbox::kernel
