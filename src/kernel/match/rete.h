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
/// Order is part of the contract: every list is last in, first out, as kernel_algorithms says, so that firing order,
/// identifiers and time tags equal those of the reference.
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

  /// Builds or shares nodes for the rule's conditions and matches it with working memory at once. A rule whose
  /// conditions end at the same node as another's and whose actions are equal is a duplicate and is not added.
  Added AddProduction(ProductionPtr production, const GoalView& goals, const AddOptions& options);
  Added AddProduction(ProductionPtr production, const GoalView& goals) {
    return AddProduction(std::move(production), goals, AddOptions());
  }
  /// Removes the rule and its unshared nodes. Its pending assertions vanish; its fired matches become retractions,
  /// which the caller sees as usual. The rule stays readable until the last of them is released.
  void ExciseProduction(ProductionId production);
  /// Null for a number that is not in use.
  const ProductionPtr& production(ProductionId id) const;
  /// Called when a match of a rule both elaborates and applies its operator; once per match. The match is then
  /// i-supported.
  void OnMixedSupport(std::function<void(ProductionId)> callback);
  /// Whether such a match has o-support (then the callback is not called).
  void MixedSupportIsO(bool is_o);

  // Working memory --------------------------------------------------------------------------------------------------

  /// Adds to the match an element that the table already holds, or removes one that it still holds.
  void AddWme(WmeId wme, const GoalView& goals);
  void RemoveWme(WmeId wme, const GoalView& goals);
  /// Forgets all elements and matches, keeps the rules (init-soar).
  void Clear();
  /// Call when memory ran out in the middle of a change: frees the memory of partial matches. After that nothing may be
  /// matched; rules and the match set stay readable, and the queries below find no matches.
  void Abandon();

  /// A match without a rule in the network, fired from the start: it becomes a retraction as soon as one of the
  /// elements leaves the match. A justification without negated conditions needs no more. `production` of such a match
  /// is ProductionId::kNone.
  MatchId AddFixedMatch(std::span<const WmeId> wmes, Symbol goal, GoalLevel level, InstantiationId instantiation);
  /// Ends the match as if one of its elements left.
  void RetractFixedMatch(MatchId match);

  /// The most partial matches at the same time: more throw std::bad_alloc, as if memory had run out. (Partial matches
  /// that a memory parks are counted separately, memory by memory.)
  void LimitPartialMatches(std::uint32_t most);
  /// True if this limit left no room.
  bool at_limit() const;

  /// A memory parks the partial matches that join with nothing once so many more have come in vain than not (256).
  /// Changes speed only; for tests.
  void ParkAfter(std::uint32_t matches);
  /// How many nodes must wait for an alpha memory's elements before it tracks which node waits for which identifier
  /// (32). Changes speed only; for tests.
  void BusyFrom(std::uint32_t nodes);
  /// Whether conjunctive negations of rules added from now on may be shared (rete_shared.cpp): yes, unless a test
  /// compares the two ways.
  void ShareConjunctions(bool share);

  // The match set ---------------------------------------------------------------------------------------------------

  MatchSet& matches() { return matches_; }
  const MatchSet& matches() const { return matches_; }
  std::span<const WmeId> Wmes(MatchId match) const { return matches_.Wmes(match); }

  // Partial matches, for display ------------------------------------------------------------------------------------
  // A condition is addressed by its path: {2} is the third top-level condition, {1, 0} the first one inside the
  // conjunctive negation at place 1. A partial match lists the elements of the positive conditions from the first
  // top-level condition to the one addressed (inside a conjunctive negation: those in front of it, then its own).

  using PartialMatches = std::vector<std::vector<WmeId>>;
  /// How many partial matches pass this condition (a negated one: are not blocked by it).
  std::size_t CountAfter(ProductionId production, std::span<const std::uint16_t> path) const;
  /// Oldest first.
  PartialMatches MatchesAfter(ProductionId production, std::span<const std::uint16_t> path) const;
  /// The partial matches that reach the condition, oldest first.
  PartialMatches MatchesBefore(ProductionId production, std::span<const std::uint16_t> path) const;
  /// Elements that pass the condition's constant tests, newest first. Empty for a conjunctive negation.
  std::vector<WmeId> RightMatches(ProductionId production, std::span<const std::uint16_t> path) const;
  /// Tokens in the memories of a rule; shared ones count for each rule that uses them. `complete`: includes whole
  /// matches.
  std::size_t CountTokens(ProductionId production, bool complete = true) const;
  static constexpr std::size_t kTokenBytes = 64;

  // Sharing and measuring -------------------------------------------------------------------------------------------

  std::shared_ptr<const Network> network() const;
  /// A digest of all rules added and excised so far. Agents with equal digests, equal frozen symbols and equal rules
  /// have equal topologies.
  std::uint64_t NetworkDigest() const;
  /// Replaces its own network by `network` if the two are equal, and frees the room in its own state for more nodes and
  /// rules; false (and no change) otherwise.
  bool AdoptNetwork(const std::shared_ptr<const Network>& network);

  struct Statistics {
    std::size_t productions = 0, nodes = 0, alpha_memories = 0, tokens = 0, wmes = 0;
    std::size_t shared_conjunctions = 0;
  };
  Statistics statistics() const;
  std::size_t MemoryBytes() const;   ///< This agent's part.
  std::size_t NetworkBytes() const;  ///< The topology.

  /// Checks links, counts, indices and unlinking; an empty text if all is well. Slow.
  std::string CheckInvariants() const;

 private:
  friend bool IsUntested(const Rete& rete, WmeId wme, Symbol value);
  friend void Renew(Rete& rete, WmeId wme);

  friend struct ReteState;
  friend std::uint64_t ArrivalOf(const Rete& rete, WmeId wme);
  MatchSet matches_;
  std::unique_ptr<struct ReteState> state_;
};

/// True for an element of the match that no rule tests, and that none would test with this value in place of its own.
bool IsUntested(const Rete& rete, WmeId wme, Symbol value);
/// Does for such an element, when its value has changed, what removing it and adding another one in its place would do.
void Renew(Rete& rete, WmeId wme);
/// When an element entered the match, as a running number; 0 for one that is not in it.
std::uint64_t ArrivalOf(const Rete& rete, WmeId wme);

}  // namespace soarbox::kernel
