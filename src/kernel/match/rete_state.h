// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kernel/match/record_array.h"
#include "kernel/match/match_set.h"
#include "kernel/match/network.h"
#include "kernel/match/rete.h"
#include "kernel/match/table_pool.h"

namespace soarbox::kernel {

/// A partial match at a node, or a blocking result. Tokens of a parent form a list, newest first; so do the tokens that
/// hold an element. Kinds, by node:
///
/// * memory, negative, conjunctive: stands in the chain of its node's memory (`chain`, by `key`).
/// * result of a negative node (kResultBit set): child of the negative token that it blocks; no chain. A blocked token
///   has results as children, an open one has tokens of later nodes: never both.
/// * partner: a result inside a conjunction; child of the token above it, and in the chain of results of the
///   conjunctive token `key`, which is blocked (kBlockedBit) while it has any: then its `first_child` is that chain.
/// * production: `key` is the match.
/// * kWatchNode: `parent` is kNil, `key` the match, `chain` links the match's other watch tokens.
struct Token {
  std::uint32_t parent;
  std::uint32_t wme;
  std::uint32_t node;
  std::uint32_t first_child;
  std::uint32_t next_sibling, previous_sibling;
  std::uint32_t next_of_wme, previous_of_wme;
  std::uint32_t next_in_chain, previous_in_chain;
  std::uint32_t key;
  std::uint32_t serial;  ///< Negative, conjunctive: running number, orders the tokens of one memory.

  static constexpr std::uint32_t kResultBit = 0x80000000u;
  static constexpr std::uint32_t kBlockedBit = 0x40000000u;
  static constexpr std::uint32_t kNodeMask = 0x3FFFFFFFu;
  static constexpr std::uint32_t kWatchNode = 0x3FFFFFFFu;
};

/// An element in an alpha memory.
struct AlphaItem {
  std::uint32_t wme;
  std::uint32_t alpha;
  std::uint32_t id, value;  ///< Symbol bits of the element, for chains.
  std::uint32_t next, previous;                      ///< All items of the memory, newest first.
  std::uint32_t next_in_bucket, previous_in_bucket;  ///< Index by identifier, if the memory has one.
  std::uint32_t next_in_pair;                        ///< Index by identifier and value, if it has one.
  std::uint32_t next_of_wme;
};

struct AlphaState {
  std::uint32_t first = kNil;                         ///< Items.
  std::uint32_t count = 0;
  std::uint32_t first_node = kNil, last_node = kNil;  ///< Right-linked nodes; descendants stand before ancestors.
  std::uint32_t id_table = 0, pair_table = 0;
  std::uint8_t id_bits = 0, pair_bits = 0;            ///< 0: no table; the items are searched one by one.
  std::uint32_t spare = 0;                            ///< Makes it 32 bytes.
};
static_assert(sizeof(AlphaState) == 32, "alpha memories are addressed by a shift");

/// A node's part of the agent's state.
///
/// Unlinking: a join is not in its memory's list while its alpha memory is empty, and not in the alpha memory's list
/// while its memory is empty, but it is always in at least one of the two. A negative node is in its alpha memory's list
/// exactly while it has tokens.
struct NodeState {
  std::uint32_t head = kNil;          ///< Tokens: the chain if bits is 0, else a table of chains.
  std::uint32_t count = 0;
  std::uint32_t first_linked = kNil;  ///< Memory: left-linked joins, last linked first.
  std::uint32_t next_left = kNil, previous_left = kNil;    ///< Join: in its memory's list.
  std::uint32_t next_right = kNil, previous_right = kNil;  ///< Join, negative: in the alpha memory's list.
  std::uint8_t bits = 0;
  bool left_linked = false;
  bool right_linked = false;
};

struct WmeLinks {
  std::uint32_t first_item = kNil;
  std::uint32_t first_token = kNil;
  std::uint32_t next = kNil, previous = kNil;  ///< All elements in the match, newest first.
  bool in_match = false;
};

/// The contents of one agent's Rete and the algorithms on it, file by file: rete_match (additions), rete_remove,
/// rete_build (rules), rete_query, rete_check.
struct [[gnu::visibility("hidden")]] ReteState {
  ReteState(MatchSet& matches, const SymbolTable& symbols, const WmeTable& wmes);
  ~ReteState();
  ReteState(const ReteState&) = delete;
  ReteState& operator=(const ReteState&) = delete;

  MatchSet& matches;
  const SymbolTable& symbols;
  const WmeTable& wmes;
  GoalView goals;
  std::shared_ptr<Network> network;                ///< Changed only while this agent alone holds it.
  std::function<void(ProductionId)> on_mixed_support;

  RecordArray<Token> tokens;
  std::uint32_t free_tokens = kNil;
  std::uint32_t token_count = 0;
  std::uint32_t next_serial = 0;
  RecordArray<AlphaItem> items;
  std::uint32_t free_items = kNil;
  std::vector<AlphaState> alphas;
  std::vector<NodeState> nodes;
  std::vector<WmeLinks> links;
  std::uint32_t newest_wme = kNil;
  std::uint32_t wme_count = 0;
  TablePool tables;
  std::uint64_t last_timetag = 0;
  std::uint32_t removing = kNil;                   ///< The element that RemoveWme works on.
  std::vector<WmeId> elements;                     ///< Scratch for a new match.
  std::vector<char> mixed_reported;                ///< By rule.
  std::vector<std::uint32_t> excised;              ///< Rules excised whose last match may not be released yet.
  std::vector<ProductionPtr> retired;              ///< By number: excised rules, until the number is used again.
  bool excising = false;
  std::vector<std::uint32_t> free_rules;           ///< Free rule numbers, last freed last.
  std::unique_ptr<class ReteBuilder> builder;      ///< Keeps its scratch memory from rule to rule.
  // While a new rule is matched for the first time:
  std::uint32_t refracting_node = kNil;
  std::span<const WmeId> refracted;
  InstantiationId refracting_instantiation = InstantiationId::kNone;
  MatchId refracted_match = MatchId::kNone;

  // rete_match.cpp
  void AddWme(std::uint32_t wme);
  void AddItem(std::uint32_t alpha, std::uint32_t wme);
  void RightActivate(std::uint32_t node, std::uint32_t wme);
  void Emit(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void Left(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftMemory(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  bool LinkJoin(std::uint32_t node);
  void LeftNegative(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftConjunctive(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftPartner(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftProduction(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void Block(std::uint32_t token, std::uint32_t wme);
  MatchId Watch(std::span<const WmeId> wmes, Symbol goal, GoalLevel level, InstantiationId instantiation);
  bool Passes(const Node& node, std::uint32_t left, const Wme& wme) const;
  std::uint32_t KeyOfToken(const Node& memory, std::uint32_t token) const;
  std::uint32_t NewToken(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void GrowChains(std::uint32_t node);
  void BuildIdTable(std::uint32_t alpha, std::uint8_t bits);
  void BuildPairTable(std::uint32_t alpha, std::uint8_t bits);

  // rete_link.cpp
  void LinkLeft(std::uint32_t node);
  void UnlinkLeft(std::uint32_t node);
  void LinkRight(std::uint32_t node);
  void UnlinkRight(std::uint32_t node);

  // rete_remove.cpp
  void RemoveWme(std::uint32_t wme);
  void RemoveItem(std::uint32_t item);
  void RemoveResult(std::uint32_t token);
  void RemoveSubtree(std::uint32_t token);
  void RemoveLeaf(std::uint32_t token);
  void RemoveRareLeaf(std::uint32_t token, NodeKind kind);
  void RemoveFromChain(std::uint32_t node, std::uint32_t token);
  void UnlinkToken(std::uint32_t token);
  void FreeToken(std::uint32_t token);
  void RemoveWatch(std::uint32_t token);
  void EndWatch(std::uint32_t first);
  void Clear();

  // rete_build.cpp
  Rete::Added AddProduction(ProductionPtr production, const Rete::AddOptions& options);
  void ExciseProduction(std::uint32_t production);
  void OwnNetwork();
  std::uint32_t MakeAlpha(const std::uint32_t (&constants)[3], std::uint32_t mask, bool acceptable);
  void DropAlpha(std::uint32_t alpha);
  void NodeAdded(std::uint32_t node);
  void Prime(std::uint32_t child);
  void RemoveNode(std::uint32_t node);
  void RemoveUnused(std::uint32_t node);
  void RemoveTokens(std::uint32_t node);
  std::uint32_t TakeRuleNumber();

  // rete_query.cpp
  using Emission = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Emission> Emissions(std::uint32_t node) const;
  std::vector<std::uint32_t> TokensByAge(std::uint32_t node) const;
  template <typename Visit>
  void ForEachToken(std::uint32_t node, Visit&& visit) const {
    const NodeState& state = nodes[node];
    const std::uint32_t chains = state.bits == 0 ? 1u : 1u << state.bits;
    for (std::uint32_t n = 0; n < chains; ++n) {
      std::uint32_t token = state.bits == 0 ? state.head : tables[state.head + n];
      while (token != kNil) {
        const std::uint32_t next = tokens[token].next_in_chain;
        visit(token);
        token = next;
      }
    }
  }

  /// The highest `bits` bits (1 to 31) of a product.
  static std::uint32_t Hash(std::uint32_t key, std::uint32_t bits) { return (key * 0x9E3779B1u) >> ((0u - bits) & 31u); }
  static std::uint32_t PairKey(std::uint32_t id, std::uint32_t value) { return (id * 0x85EBCA6Bu) ^ (value * 0xC2B2AE35u); }
  static std::uint32_t FieldOf(const Wme& wme, Field field) {
    static_assert(offsetof(Wme, id) == 0 && offsetof(Wme, attribute) == 4 && offsetof(Wme, value) == 8 &&
                  static_cast<int>(Field::kValue) == 2 && sizeof(Symbol) == 4);
    std::uint32_t bits;
    std::memcpy(&bits, reinterpret_cast<const char*>(&wme) + 4 * static_cast<std::size_t>(field), sizeof(bits));
    return bits;
  }
  GoalLevel GoalLevelOf(Symbol id) const {
    return id.IsIdentifier() && id.index() < goals.level_of_goal.size() ? goals.level_of_goal[id.index()] : GoalLevel{0};
  }
  std::uint64_t LtiOf(Symbol id) const {
    return id.IsIdentifier() && id.index() < goals.lti_of.size() ? goals.lti_of[id.index()] : 0;
  }
};

}  // namespace soarbox::kernel
