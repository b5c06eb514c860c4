// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kernel/match/alpha_memories.h"
#include "kernel/match/element_links.h"
#include "kernel/match/match_set.h"
#include "kernel/match/match_support.h"
#include "kernel/match/meeting_order.h"
#include "kernel/match/network.h"
#include "kernel/match/node_states.h"
#include "kernel/match/only_ids.h"
#include "kernel/match/rete.h"
#include "kernel/match/right_side.h"
#include "kernel/match/rule_numbers.h"
#include "kernel/match/sparse_memories.h"
#include "kernel/match/token_pool.h"

namespace soarbox::kernel {

/// Shared conjunctions (rete_shared.cpp).
struct SharedConjunctions {
  bool allowed = true;                           ///< See Rete::ShareConjunctions.
  bool exist = false;                            ///< There are some, or have been.
  bool path_element = false;                     ///< The element that is leaving may be part of a path.
  std::uint32_t last_owner = kNil;               ///< That was made.
  std::vector<std::uint32_t> new_paths;          ///< Paths whose owners are still to be blocked.
  std::vector<OwnerAndPath> pairings, openings;  ///< Scratch.
};

/// While a new rule is matched for the first time: the match that counts as fired.
struct Refraction {
  std::uint32_t node = kNil;  ///< Of the rule.
  std::span<const WmeId> elements;
  InstantiationId instantiation = InstantiationId::kNone;
  MatchId match = MatchId::kNone;  ///< Once it was found.
};

/// The contents of one agent's Rete, in parts that own what they hold, and the algorithms that need several of them,
/// file by file: rete_match (additions), rete_join (joins and memories), rete_sparse (memories that park pairs),
/// rete_shared (conjunctions that tokens share), rete_guard (justifications with negations), rete_remove, rete_build
/// (rules), rete_query, rete_check.
struct [[gnu::visibility("hidden")]] ReteState {
  ReteState(MatchSet & matches, const SymbolTable& symbols, const WmeTable& wmes);
  ~ReteState();
  ReteState(const ReteState&) = delete;
  ReteState& operator=(const ReteState&) = delete;

  MatchSet& matches;
  const SymbolTable& symbols;
  const WmeTable& wmes;
  GoalView goals;
  std::shared_ptr<Network> network;  ///< Changed only while this agent alone holds it.

  // The parts.
  TokenPool tokens;
  ElementLinks links;
  AlphaMemories alphas;
  NodeStates nodes;
  SparseMemories sparse;
  OnlyIds only_ids;
  SharedConjunctions shared;
  MatchSupport support;
  RuleNumbers rules;
  Refraction refraction;
  std::unique_ptr<class ReteBuilder> builder;  ///< Keeps its scratch memory from rule to rule.

  std::uint32_t most_partial_matches = 0xFFFFFFFFu;
  bool excising = false;
  bool abandoned = false;               ///< There are no tokens any more, whatever matches.
  std::vector<WmeId> elements;          ///< Scratch for a new match.
  std::vector<std::uint32_t> gathered;  ///< Scratch: tokens that an element joins with.

  // rete_match.cpp
  void AddWme(std::uint32_t wme);
  void Emit(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void Left(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftMemory(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  bool LinkJoin(std::uint32_t node);
  void LinkOnlyJoin(std::uint32_t memory, std::uint32_t join);
  [[gnu::noinline]] void LeftNegative(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  [[gnu::noinline]] void LeftConjunctive(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  [[gnu::noinline]] void LeftPartner(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftProduction(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void NewMatch(std::uint32_t node, std::uint32_t parent, std::uint32_t wme, std::uint32_t production,
                const RuleInfo& rule);
  void Block(std::uint32_t token, std::uint32_t wme);
  void BlockOwner(std::uint32_t owner, std::uint32_t parent, std::uint32_t wme);
  MatchId AddFixedMatch(std::span<const WmeId> wmes, Symbol goal, GoalLevel level, InstantiationId instantiation);
  bool PassesTest(const NodeTest& test, std::uint32_t parent, std::uint32_t left, const Wme& wme) const;
  bool PassesOne(const NodeTest& test, std::uint32_t parent, std::uint32_t left, const Wme& wme) const;
  bool Passes(const Node& node, std::uint32_t parent, std::uint32_t left, const Wme& wme) const;
  bool Passes(const Node& node, std::uint32_t token, const Wme& wme) const {
    return Passes(node, tokens[token].parent, tokens[token].wme, wme);
  }
  std::uint32_t KeyOfToken(const Node& memory, std::uint32_t token) const;
  std::uint32_t NewToken(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);

  // rete_link.cpp
  void LinkLeft(std::uint32_t node);
  void UnlinkLeft(std::uint32_t node);
  void LinkRight(std::uint32_t node);
  void UnlinkRight(std::uint32_t node);

  // rete_remove.cpp
  void RemoveWme(std::uint32_t wme);
  void RemoveItem(std::uint32_t item);
  void RemoveTokenOfElement(std::uint32_t token);
  void RemoveResult(std::uint32_t token);
  void RemoveSubtree(std::uint32_t token);
  void MemoryEmptied(std::uint32_t node);
  void RemoveRareLeaf(std::uint32_t token);
  void FreeResults(std::uint32_t owner);
  void RetractFixedMatch(std::uint32_t token);
  void FreeFixedMatch(std::uint32_t first);
  void Clear();
  void Abandon();

  // rete_join.cpp
  void RightJoin(std::uint32_t join, const Node& node, std::uint32_t wme, const Wme& element);
  void RightMatch(std::uint32_t join, std::uint32_t wme, std::uint32_t token, std::uint32_t key);
  void RightNegative(std::uint32_t index, const Node& node, std::uint32_t wme);
  void RightFirst(std::uint32_t first, std::uint32_t wme);
  void RightAll(std::uint32_t first, std::uint32_t wme, const Wme& element);
  void RightSparse(std::uint32_t join, std::uint32_t wme);
  void EmitGathered(std::uint32_t join, std::uint32_t wme);
  void JoinSparsely(std::uint32_t node, std::uint32_t parent, std::uint32_t wme, std::uint64_t serial, KeyParts key,
                    std::uint32_t item);
  void JoinFrom(std::uint32_t join, const Node& node, std::uint32_t token, KeyParts key, std::uint32_t item);
  void JoinSparse(const Node& join, const RightSide& right, std::uint32_t token, const KeyParts& key,
                  std::uint32_t item);
  void JoinHop(std::uint32_t node, std::uint32_t token, std::uint32_t id, std::uint32_t item);
  template <RightSide::Kind kind>
  void JoinRuns(const RightSide& right, std::uint32_t node, std::uint32_t token, std::uint32_t id, std::uint32_t item);
  void LeftSparse(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void JoinBucket(std::uint32_t memory, std::uint32_t token, std::uint32_t id, std::uint32_t item);
  void LeftPlain(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void JoinOne(std::uint32_t join, std::uint32_t token, const KeyParts& key);
  void JoinRest(std::uint32_t next, std::uint32_t token, KeyParts key);
  void JoinAll(const NodeState& memory, std::uint32_t token, const KeyParts& key);
  std::uint32_t MakeAnchor(std::uint32_t anchors, std::uint32_t id);
  [[gnu::noinline]] void RightBusy(std::uint32_t first, std::uint32_t wme);
  [[gnu::noinline]] void SecondToken(std::uint32_t first_join);

  // rete_link.cpp, but for the inline ones
  [[gnu::noinline]] void FindOnlyId(std::uint32_t node);
  void NoteNodes(std::uint32_t alpha);

  // rete_sparse.cpp
  void GatherParked(std::uint32_t join, std::uint32_t wme, std::uint32_t key);
  std::uint32_t Unpark(std::uint32_t node, const ParkedPair& pair);
  bool IsStale(const ParkedPair& pair) const {
    return SparseMemories::IsStale(tokens, links, pair);
  }
  void GatherFromRuns(std::uint32_t join, std::uint32_t wme, std::uint32_t key);
  bool TakeFromRun(std::uint32_t node, ParkedPair & pair);
  void ExpandRuns(std::uint32_t node);
  void ForgetPairs(std::uint32_t join, std::uint32_t wme);
  /// Counts off pairs of a sparse memory.
  void ForgetPairsOf(std::uint32_t memory, std::uint32_t pairs) {
    std::uint32_t& count = nodes[memory].count;
    count -= pairs;
    if (count == 0) {
      SparseEmptied(memory);
    }
  }
  /// The sparse memory below a memory.
  std::uint32_t SparseBelow(std::uint32_t memory) const {
    return network->node(network->node(memory).first_child).only_memory;
  }
  [[gnu::noinline]] void SparseEmptied(std::uint32_t memory);
  SparseState& SparseOf(std::uint32_t node) {
    return sparse[nodes[node].place];
  }
  const SparseState& SparseOf(std::uint32_t node) const {
    return sparse[nodes[node].place];
  }
  bool CanBeSparse(std::uint32_t node) const;
  // rete_shared.cpp
  void LeftShared(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void LeftPath(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void OwnerGone(std::uint32_t anchor);
  bool Pairs(std::uint32_t owner, std::uint32_t path) const;
  void BlockOwners(std::uint32_t above);
  void RemoveTokensInOrder(std::uint32_t wme);
  bool IsInPath(const Token& token) const;
  void FindOpenings(std::uint32_t wme);
  void OpenOwner(const OwnerAndPath& opening);
  std::vector<std::uint32_t> OwnersOf(std::uint32_t conjunctive, std::uint32_t join, std::uint32_t parent,
                                      std::uint32_t wme) const;
  bool StaysBlocked(std::uint32_t owner, std::uint32_t wme) const;

  // rete_guard.cpp
  bool CanBeGuarded(const RuleInfo& info, const Rete::AddOptions& options) const;
  bool AddGuarded(const std::shared_ptr<RuleInfo>& info, std::uint32_t number, const Rete::AddOptions& options);
  [[gnu::noinline]] void LeftGuard(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void GuardedElementGone(std::uint32_t node);

  void MakeScoredSparse();
  void MakeSparse(std::uint32_t node);
  void MakePlain(std::uint32_t node);
  void MakePlainForNow(std::uint32_t node);
  void ChildAdded(std::uint32_t node);

  // rete_build.cpp
  Rete::Added AddProduction(ProductionPtr production, const Rete::AddOptions& options);
  void EnterRule(const std::shared_ptr<RuleInfo>& info, std::uint32_t number, std::uint32_t node);
  void MatchNewRule(std::uint32_t node, const Rete::AddOptions& options);
  void ExciseProduction(std::uint32_t production);
  void OwnNetwork();
  std::uint32_t MakeAlpha(const std::uint32_t(&constants)[3], std::uint32_t mask, bool acceptable);
  void DropAlpha(std::uint32_t alpha);
  void NodeAdded(std::uint32_t node);
  void Prime(std::uint32_t child);
  void RemoveNode(std::uint32_t node);
  void RemoveUnused(std::uint32_t node);
  void RemoveTokens(std::uint32_t node);

  // rete_query.cpp
  using Emission = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Emission> Emissions(std::uint32_t node) const;
  void AddEmissions(std::uint32_t node, std::vector<Emission> & out) const;
  std::vector<Emission> primed;  ///< Room for Prime.
  std::vector<std::uint32_t> TokensByAge(std::uint32_t node) const;

  static std::uint32_t FieldOf(const Wme& wme, Field field) {
    return kernel::FieldOf(wme, field).bits();
  }
};

}  // namespace soarbox::kernel
