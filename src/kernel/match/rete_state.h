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
#include "kernel/match/emissions.h"
#include "kernel/match/join_links.h"
#include "kernel/match/match_set.h"
#include "kernel/match/match_support.h"
#include "kernel/match/network.h"
#include "kernel/match/node_states.h"
#include "kernel/match/only_ids.h"
#include "kernel/match/pair_tests.h"
#include "kernel/match/rete.h"
#include "kernel/match/right_side.h"
#include "kernel/match/rule_numbers.h"
#include "kernel/match/shared_conjunctions.h"
#include "kernel/match/sparse_feeders.h"
#include "kernel/match/sparse_memories.h"
#include "kernel/match/token_pool.h"

namespace soarbox::kernel {

/// The match that counts as fired, during a new rule's first match.
struct Refraction {
  std::uint32_t node = kNil;  ///< Of the rule.
  std::span<const WmeId> elements;
  InstantiationId instantiation = InstantiationId::kNone;
  MatchId match = MatchId::kNone;  ///< Set once it is found.
};

/// The contents of one agent's Rete, in parts that own their data, and the algorithms that need several parts. By file:
/// rete_match (additions), rete_join (joins and memories), rete_sparse (memories that park pairs), rete_shared
/// (conjunctions that tokens share), rete_guard (justifications with negations), rete_remove, rete_nodes (adding and
/// removing nodes). Code that needs only a few parts has access only to these: PairTests, JoinLinks, EmissionReader,
/// SharedConjunctions, fixed_match. ReteBuilder (rete_rules, rete_builder) adds and removes rules; the queries are in
/// rete_query and rete_check.
struct [[gnu::visibility("hidden")]] ReteState {
  ReteState(MatchSet & matches, const SymbolTable& symbols, const WmeTable& wmes);
  ~ReteState();
  ReteState(const ReteState&) = delete;
  ReteState& operator=(const ReteState&) = delete;

  MatchSet& matches;
  const SymbolTable& symbols;
  const WmeTable& wmes;
  GoalView goals;
  std::shared_ptr<Network> network;  ///< Changed only while no other agent uses it.

  // The parts.
  TokenPool tokens;
  ElementLinks links;
  AlphaMemories alphas;
  NodeStates nodes;
  SparseMemories sparse;
  SparseFeeders feeders;
  OnlyIds only_ids;
  SharedConjunctions shared;
  MatchSupport support;
  PairTests pair_tests;
  RuleNumbers rules;
  Refraction refraction;
  std::unique_ptr<class ReteBuilder> builder;  ///< Keeps its scratch memory from rule to rule.

  std::uint32_t most_partial_matches = 0xFFFFFFFFu;
  bool excising = false;
  bool abandoned = false;               ///< There are no tokens any more, whatever matches.
  std::vector<WmeId> elements;          ///< Scratch for a new match.
  std::vector<Emission> primed;         ///< Scratch for Prime.
  std::vector<std::uint32_t> gathered;  ///< Scratch: tokens that an element joins with.

  [[gnu::always_inline]] JoinLinks joins() {
    return {*network, alphas, nodes, only_ids, tokens, wmes};
  }

  EmissionReader emissions() const {
    return {*network, alphas, nodes, tokens, wmes, pair_tests};
  }

  // rete_match.cpp
  void AddWme(std::uint32_t wme);
  void Emit(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void Left(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftMemory(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  [[gnu::noinline]] void LeftNegative(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  [[gnu::noinline]] void LeftConjunctive(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  [[gnu::noinline]] void LeftPartner(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftProduction(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void NewMatch(std::uint32_t node, std::uint32_t parent, std::uint32_t wme, std::uint32_t production,
                const RuleInfo& rule);
  void Block(std::uint32_t token, std::uint32_t wme);
  void BlockOwner(std::uint32_t owner, std::uint32_t parent, std::uint32_t wme);

  // rete_remove.cpp
  void RemoveWme(std::uint32_t wme);
  void RemoveItem(std::uint32_t item);
  void RemoveTokenOfElement(std::uint32_t token);
  void RemoveResult(std::uint32_t token);
  void RemoveSubtree(std::uint32_t token);
  void RemoveRareLeaf(std::uint32_t token);
  void RetractFixedMatch(std::uint32_t token);
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
  template <KeyKind kind>
  void JoinRuns(const RightSide& right, std::uint32_t node, std::uint32_t token, std::uint32_t id, std::uint32_t item);
  void LeftSparse(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void JoinBucket(std::uint32_t memory, std::uint32_t token, std::uint32_t id, std::uint32_t item);
  void LeftPlain(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void JoinOne(std::uint32_t join, std::uint32_t token, const KeyParts& key);
  void JoinRest(std::uint32_t next, std::uint32_t token, KeyParts key);
  void JoinAll(const NodeState& memory, std::uint32_t token, const KeyParts& key);
  std::uint32_t MakeAnchor(std::uint32_t anchors, std::uint32_t id);
  [[gnu::noinline]] void RightBusy(std::uint32_t first, std::uint32_t wme);

  // rete_sparse.cpp
  void GatherParked(std::uint32_t join, std::uint32_t wme, std::uint32_t key);
  std::uint32_t Unpark(std::uint32_t node, const ParkedPair& pair);
  void GatherFromRuns(std::uint32_t join, std::uint32_t wme, std::uint32_t key);
  bool TakeFromRun(std::uint32_t node, ParkedPair & pair);
  void ExpandRuns(std::uint32_t node);
  void ForgetPairs(std::uint32_t join, std::uint32_t wme);
  /// Subtracts pairs from the count of a sparse memory.
  void ForgetPairsOf(std::uint32_t memory, std::uint32_t pairs) {
    std::uint32_t& count = nodes[memory].count;
    count -= pairs;
    if (count == 0) {
      joins().SparseEmptied(memory);
    }
  }
  SparseState& SparseOf(std::uint32_t node) {
    return sparse[nodes[node].place];
  }
  const SparseState& SparseOf(std::uint32_t node) const {
    return sparse[nodes[node].place];
  }
  void MakeScoredSparse();
  void MakeSparse(std::uint32_t node);
  void MakePlain(std::uint32_t node);
  void ChildAdded(std::uint32_t node);

  // rete_shared.cpp
  void LeftShared(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void LeftPath(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void BlockOwners(std::uint32_t above);
  void RemoveTokensInOrder(std::uint32_t wme);
  void OpenOwner(const OwnerAndPath& opening);

  // rete_guard.cpp
  [[gnu::noinline]] void LeftGuard(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void GuardedElementGone(std::uint32_t node);

  // rete_nodes.cpp
  void NodeAdded(std::uint32_t node);
  void Prime(std::uint32_t child);
  void RemoveNode(std::uint32_t node);
  void RemoveTokens(std::uint32_t node);
};

}  // namespace soarbox::kernel
