// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/match/goal_view.h"
#include "kernel/match/match_set.h"
#include "kernel/match/wme.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

class SymbolTable;
class Network;

/// One agent's matcher: Rete with left and right unlinking (Doorenbos, Production Matching for Large Learning Systems,
/// 1995), hashed joins, negation and conjunctive negation.
///
/// The topology (Network) is immutable once shared and common to all agents that run the same rules; the contents of
/// memories, links and pending matches (this class) belong to the agent. Adding or excising a rule first forks a shared
/// topology. No allocation in the steady state.
///
/// The order is part of the contract: every list is last in, first out (docs/spec/kernel_algorithms.md), so that firing
/// order, identifiers and time tags equal those of Soar.
///
/// Single-threaded per agent.
class Rete {
 public:
  enum class AddResult : std::uint8_t { kAdded, kDuplicate };
  struct Added {
    AddResult result = AddResult::kAdded;
    ProductionId production = ProductionId::kNone;  ///< The new rule, or the one it duplicates.
    MatchId refracted = MatchId::kNone;             ///< See AddOptions; kNone if that match does not exist.
  };
  struct AddOptions {
    /// Two RL rules that differ only in their number are duplicates (`rl chunk-stop on`).
    bool ignore_rl_value = false;
    /// A new rule's match of exactly these elements counts as fired from the start, by `instantiation` (chunks).
    std::span<const WmeId> refracted;
    InstantiationId instantiation = InstantiationId::kNone;
  };

  Rete(const SymbolTable& symbols, const WmeTable& wmes);
  ~Rete();
  Rete(const Rete&) = delete;
  Rete& operator=(const Rete&) = delete;

  // Rules -----------------------------------------------------------------------------------------------------------

  /// Builds or shares nodes for the rule's conditions, and matches it with working memory immediately. The rule is a
  /// duplicate if its conditions end at the same node as those of another rule and the actions are equal. A duplicate
  /// is not added.
  Added AddProduction(ProductionPtr production, const GoalView& goals, const AddOptions& options);
  Added AddProduction(ProductionPtr production, const GoalView& goals) {
    return AddProduction(std::move(production), goals, AddOptions());
  }
  /// Removes the rule and its unshared nodes. Its pending assertions disappear; its fired matches become retractions,
  /// which the caller takes as usual. The rule is readable until the last of them is released.
  void ExciseProduction(ProductionId production);
  /// Null for a number that is not in use.
  const ProductionPtr& production(ProductionId id) const;
  /// Called when the actions of a new match both elaborate and apply the operator that a match of the same rule tests:
  /// once for each such match. The new match is then i-supported, unless a match that is considered later decides
  /// otherwise (MatchSupport::ByMatches).
  void OnMixedSupport(std::function<void(ProductionId)> callback);
  /// Whether such a match gets o-support (then the callback is not called).
  void MixedSupportIsO(bool is_o);

  // Working memory --------------------------------------------------------------------------------------------------

  /// Adds an element that is in the table to the match, or removes one that is still in the table.
  void AddWme(WmeId wme, const GoalView& goals);
  void RemoveWme(WmeId wme, const GoalView& goals);
  /// Removes all elements and matches, but keeps the rules (init-soar).
  void Clear();
  /// Call it after memory ran out in the middle of a change. Frees the memory of partial matches. Nothing may be
  /// matched afterwards. Rules and the match set stay readable, and the queries below find no matches.
  void Abandon();

  /// Adds a match without a rule in the network, fired from the start. It becomes a retraction as soon as one of the
  /// elements leaves the match. This is sufficient for a justification without negated conditions. `production` of such
  /// a match is ProductionId::kNone.
  MatchId AddFixedMatch(std::span<const WmeId> wmes, Symbol goal, GoalLevel level, InstantiationId instantiation);
  /// Ends the match as if one of its elements had left.
  void RetractFixedMatch(MatchId match);

  /// Maximum number of simultaneous partial matches. Exceeding it throws std::bad_alloc, as if memory had run out.
  /// (Parked pairs are counted separately: those in the log of each memory, and those in all tables together.)
  void LimitPartialMatches(std::uint32_t most);
  /// True if this limit was reached.
  bool at_limit() const;

  /// A memory starts to park pairs when its score reaches `matches` (256). Each pair that joins with nothing adds 1 to
  /// the score; pairs that join lower it. Changes only the speed; for tests.
  void ParkAfter(std::uint32_t matches);
  /// When the number of nodes that wait for the elements of an alpha memory reaches `nodes` (32), the memory starts to
  /// store which node waits for which identifier. Changes only the speed; for tests.
  void BusyFrom(std::uint32_t nodes);
  /// Whether conjunctive negations of rules added from now on may be shared (rete_shared.cpp). On, except in tests that
  /// compare both ways.
  void ShareConjunctions(bool share);

  // The match set ---------------------------------------------------------------------------------------------------

  MatchSet& matches() { return matches_; }
  const MatchSet& matches() const { return matches_; }
  std::span<const WmeId> Wmes(MatchId match) const { return matches_.Wmes(match); }

  // Partial matches, for display ------------------------------------------------------------------------------------
  // A condition is addressed by its path: {2} is the third top-level condition, {1, 0} the first one inside the
  // conjunctive negation at place 1. A partial match lists the elements of the positive conditions, from the first
  // top-level condition to the addressed one. Inside a conjunctive negation, these are the conditions before the
  // negation, then those in it.

  using PartialMatches = std::vector<std::vector<WmeId>>;
  /// Number of partial matches that pass this condition (for a negated one: that it does not block).
  std::size_t CountAfter(ProductionId production, std::span<const std::uint16_t> path) const;
  /// Oldest first.
  PartialMatches MatchesAfter(ProductionId production, std::span<const std::uint16_t> path) const;
  /// The partial matches that reach the condition, oldest first.
  PartialMatches MatchesBefore(ProductionId production, std::span<const std::uint16_t> path) const;
  /// Elements that pass the condition's constant tests, newest first. Empty for a conjunctive negation.
  std::vector<WmeId> RightMatches(ProductionId production, std::span<const std::uint16_t> path) const;
  /// Tokens in the memories of a rule; shared ones count for each rule that uses them. `complete`: includes complete
  /// matches.
  std::size_t CountTokens(ProductionId production, bool complete = true) const;
  static constexpr std::size_t kTokenBytes = 64;

  // Sharing and measuring -------------------------------------------------------------------------------------------

  std::shared_ptr<const Network> network() const;
  /// A digest of all rules added and excised so far. Agents with equal digests, equal frozen symbols and equal rules
  /// have equal topologies.
  std::uint64_t NetworkDigest() const;
  /// If `network` equals its own network, replaces its own by it, frees reserved memory for further nodes and rules,
  /// and returns true. Else changes nothing and returns false.
  bool AdoptNetwork(const std::shared_ptr<const Network>& network);

  struct Statistics {
    std::size_t productions = 0, nodes = 0, alpha_memories = 0, tokens = 0, wmes = 0;
    std::size_t shared_conjunctions = 0;
  };
  Statistics statistics() const;
  std::size_t MemoryBytes() const;   ///< This agent's part.
  std::size_t NetworkBytes() const;  ///< The topology.

  /// Checks links, counts, indices and unlinking. Returns an empty text if there is no error. Slow.
  std::string CheckInvariants() const;

 private:
  friend bool IsUntested(const Rete& rete, WmeId wme, Symbol value);
  friend void Renew(Rete& rete, WmeId wme);

  friend struct ReteState;
  friend std::uint64_t ArrivalOf(const Rete& rete, WmeId wme);
  MatchSet matches_;
  std::unique_ptr<struct ReteState> state_;
};

/// Returns true if the match contains the element, no rule tests it, and no rule would test it if it had this value.
bool IsUntested(const Rete& rete, WmeId wme, Symbol value);
/// Call after the value of such an element has changed. Equivalent to removing the old element and adding the new one.
void Renew(Rete& rete, WmeId wme);
/// The running number of an element's arrival in the match; 0 if it is not in the match.
std::uint64_t ArrivalOf(const Rete& rete, WmeId wme);

}  // namespace soarbox::kernel
