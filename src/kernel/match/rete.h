// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/match/match_set.h"
#include "kernel/memory/wme.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

class SymbolTable;

/// What the match needs to know of identifiers and goals; owned and kept up to date by working memory and the goal
/// stack. Indexed by Symbol::index() of an identifier.
struct GoalView {
  std::span<const GoalLevel> level_of_goal;   ///< The level of an identifier that is a goal, else 0.
  std::span<const std::uint64_t> lti_of;      ///< The long-term identifier that it is linked to, else 0.
};

/// One agent's matcher: Rete with left and right unlinking, hashed joins, negation and conjunctive negation.
///
/// The topology (Network) is immutable once shared and common to all agents that run the same rules; the contents of
/// memories, links and pending matches (this class) belong to the agent. Adding or excising a rule copies a shared
/// topology first. No allocation in the steady state.
///
/// Order is part of the contract: every list is last in, first out, as kernel_algorithms says, so that firing order,
/// identifiers and timetags come out as in the reference.
///
/// Single-threaded per agent.
class Rete {
 public:
  enum class AddResult : std::uint8_t { kAdded, kDuplicate };
  struct Added {
    AddResult result = AddResult::kAdded;
    ProductionId production = ProductionId::kNone;  ///< The new rule, or the one it duplicates.
  };

  Rete(const SymbolTable& symbols, const WmeTable& wmes);
  ~Rete();

  /// Builds or shares nodes for the rule's conditions and matches it against working memory at once. A rule whose
  /// conditions end at the same node and whose actions are equal to another's is a duplicate and is not added.
  Added AddProduction(ProductionPtr production);
  /// Removes the rule and its unshared nodes. Its pending assertions vanish; its fired matches become retractions,
  /// which the caller sees as usual.
  void ExciseProduction(ProductionId production);
  const ProductionPtr& production(ProductionId id) const;

  /// Adds to the match an element that the table holds already; removes one that it still holds.
  void AddWme(WmeId wme, const GoalView& goals);
  void RemoveWme(WmeId wme, const GoalView& goals);
  /// Forgets all elements and matches, keeps the rules (init-soar).
  void Clear();

  // The match set -------------------------------------------------------------------------------------------------
  // Pending work is kept per goal: the lowest goal (largest level) among the identifiers of the matched elements.
  // Assertions are split by the support that the rule would give: i (proposals, elaborations) or o (applications).
  // A list is consumed from its newest end.

  struct PendingMatch {
    MatchId match = MatchId::kNone;
    ProductionId production = ProductionId::kNone;
    Symbol goal;                       ///< None for matches that touch no goal.
    bool o_support = false;
  };

  /// The elements of a match in condition order, one per positive top-level condition. Valid until the next change.
  std::span<const WmeId> Wmes(MatchId match) const;
  // (The lists per goal, taking from them, marking as fired, goals that go away: see match_set.h and the .cpp; the
  // engineer of match/ completes this part together with the engineer of decide/.)

  std::size_t MemoryBytes() const;        ///< This agent's part.
  std::size_t NetworkBytes() const;       ///< The topology.

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soarbox::kernel
