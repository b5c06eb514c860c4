// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kernel/match/match_set.h"
#include "kernel/match/network.h"
#include "kernel/match/record_array.h"
#include "kernel/match/rete.h"
#include "kernel/match/table_pool.h"

namespace soarbox::kernel {

/// A partial match at a node, or a blocking result. Tokens of a parent form a list, newest first; so do the tokens that
/// hold an element. Kinds, by node:
///
/// * memory, negative, conjunctive: stands in a bucket of its node's memory (by `key`).
/// * result of a negative node (kResultBit set): child of the negative token that it blocks; in no bucket. A blocked
///   token has results as children, an open one has tokens of later nodes: never both.
/// * partner: a result inside a conjunction; child of the token above it, and in the list of results of the
///   conjunctive token `key`, which is blocked (kBlockedBit) while it has any: then its `first_child` is that list.
/// * shared conjunctive: stands in its node's memory; `pairs` is its anchor. Blocked likewise; a result is a child of
///   the path that blocks it and has no element.
/// * anchor: has no parent and no element; `key` is the identifier, `previous_sibling` counts its owners.
/// * production, guard: `key` is the match.
/// * kFixedMatchNode: `parent` is kNil, `key` the match, `next_in_bucket` links the match's other tokens. Of a guarded
///   rule (rete_guard.cpp): `previous_in_bucket` is kGuarded, `key` the guard.
///
/// Tokens that a parked pair was made into late stand at the wrong place of their lists: then kUnsortedBit of the
/// parent and WmeLinks::unsorted tell that the list is to be sorted by serial number before its order matters.
struct Token {
  std::uint32_t parent;
  std::uint32_t wme;
  std::uint32_t node;
  std::uint32_t first_child;
  std::uint32_t next_sibling, previous_sibling;
  std::uint32_t next_of_wme, previous_of_wme;
  std::uint32_t next_in_bucket, previous_in_bucket;
  std::uint32_t key;
  std::uint32_t pairs;      ///< Memory above a sparse one: pairs of this token that the sparse memory holds, else 0.
  std::uint64_t serial;     ///< Running number: when it (or the parked pair that it was) reached its node.
  std::uint64_t forgotten;  ///< Likewise: when a token with parked pairs last gave this record back. They are older.

  static constexpr std::uint32_t kResultBit = 0x80000000u;
  static constexpr std::uint32_t kBlockedBit = 0x40000000u;
  static constexpr std::uint32_t kUnsortedBit = 0x20000000u;
  static constexpr std::uint32_t kNodeMask = 0x1FFFFFFFu;
  static constexpr std::uint32_t kFixedMatchNode = 0x1FFFFFFFu;
  static constexpr std::uint32_t kGuarded = 0;  ///< Else kNil.
};
static_assert(sizeof(Token) == Rete::kTokenBytes);

/// A pair that reached a sparse memory and joins with nothing (rete_sparse.cpp). Stale, and as good as gone, once its
/// token or its element has left: then their records have changed hands since.
struct ParkedPair {
  std::uint32_t parent;
  std::uint32_t wme;
  std::uint64_t serial;
  std::uint32_t key;   ///< As of a token.
  std::uint32_t next;  ///< In its bucket, or in the free list.
};

/// An element in an alpha memory.
struct AlphaItem {
  std::uint32_t wme;
  std::uint32_t alpha;
  std::uint32_t id, value;                           ///< Symbol bits of the element, for its buckets.
  std::uint32_t next, previous;                      ///< All items of the memory, newest first.
  std::uint32_t next_in_bucket, previous_in_bucket;  ///< Index by identifier, if the memory has one.
  std::uint32_t next_in_pair;                        ///< Index by identifier and value, if it has one.
  std::uint32_t next_of_wme;
};

struct AlphaState {
  std::uint32_t first = kNil;  ///< Items.
  std::uint32_t count = 0;
  std::uint32_t first_node = kNil, last_node = kNil;  ///< Right-linked nodes; descendants stand before ancestors.
  std::uint32_t id_table = 0, pair_table = 0;
  std::uint8_t id_bits = 0, pair_bits = 0;  ///< 0: no table; the items are searched one by one.
  std::uint32_t sparse = 0;                 ///< Joins that feed sparse memories; kInPaths, kBusy.

  static constexpr std::uint32_t kInPaths = 0x80000000u;  ///< Joins of shared conjunctions use or have used it.
  static constexpr std::uint32_t kBusy = 0x40000000u;     ///< It has many right-linked nodes: see ReteState::only_id.
  static constexpr std::uint32_t kFlags = kInPaths | kBusy;
};
static_assert(sizeof(AlphaState) == 32, "alpha memories are addressed by a shift");

/// A node's part of the agent's state, in the four words that nodes of its kind need.
///
/// Unlinking: a join is not in its memory's list while its alpha memory is empty, and not in the alpha memory's list
/// while its memory is empty, but it is always in at least one of the two. A negative node is in its alpha memory's
/// list exactly while it has tokens.
struct NodeState {
  union {
    std::uint32_t head = kNil;  ///< Tokens: the bucket if NodeMarks::bits() is 0, else a table of buckets.
    std::uint32_t next_left;    ///< Join: in its memory's list.
  };
  union {
    std::uint32_t count = 0;  ///< Tokens; of a sparse memory also parked pairs that are not stale.
    std::uint32_t previous_left;
  };
  union {
    std::uint32_t first_linked = kNil;  ///< Memory: left-linked joins, last linked first. Guard: the tokens of its
                                        ///< rule's elements; kNil: one has left.
    std::uint32_t next_right;           ///< Join, negative: in the alpha memory's list.
  };
  union {
    std::uint32_t previous_right = kNil;
    std::uint32_t score;  ///< Memory that is not sparse: see ReteState::AddToScore.
    std::uint32_t place;  ///< Sparse memory: in ReteState::sparse.
  };
};
static_assert(sizeof(NodeState) == 16, "nodes are addressed by a shift");

/// The small part of a node's state, in an array of its own so that it costs no more than it is. One number of 16 bits:
/// storing bytes, which may be part of anything, would make the compiler forget what it has in registers.
class NodeMarks {
 public:
  // What a node has to do with sparse memories (rete_sparse.cpp).
  static constexpr std::uint16_t kSparse = 0x100;       ///< Is one.
  static constexpr std::uint16_t kAboveSparse = 0x200;  ///< Memory: its only join feeds one.
  static constexpr std::uint16_t kFeedsSparse = 0x400;  ///< Join: its only child is one.
  // What else the end of a token depends on.
  static constexpr std::uint16_t kNegative = 0x800;  ///< Is a negative node.
  static constexpr std::uint16_t kOther = 0x1000;    ///< Is neither a negative node nor a memory.
  static constexpr std::uint16_t kUncommonEnd = kSparse | kAboveSparse | kOther;
  static constexpr std::uint16_t kInPath = 0x8000;  ///< Is part of a shared conjunction.
  // See NodeState on unlinking.
  static constexpr std::uint16_t kLeftLinked = 0x2000;   ///< Join.
  static constexpr std::uint16_t kRightLinked = 0x4000;  ///< Join, negative.

  /// Any of them.
  bool Is(std::uint16_t mark) const { return (word_ & mark) != 0; }
  void Set(std::uint16_t mark) { word_ = static_cast<std::uint16_t>(word_ | mark); }
  void Unset(std::uint16_t mark) { word_ = static_cast<std::uint16_t>(word_ & ~mark); }

  /// Of the node's table of tokens; 0: it has none.
  std::uint32_t bits() const { return word_ & 0xFFu; }
  /// Of a memory: its tokens are all tokens there are, in one list.
  bool HasList() const { return (word_ & (0xFFu | kSparse)) == 0; }
  void SetBits(std::uint32_t bits) { word_ = static_cast<std::uint16_t>((word_ & 0xFF00u) | bits); }

 private:
  std::uint16_t word_ = 0;
};

/// The rest of a sparse memory's state. Pairs are parked in a log; the first element that comes from the right moves
/// them into a table by their key.
struct SparseState {
  std::uint32_t node = kNil;
  std::uint32_t tokens = 0;     ///< Pairs that are tokens.
  std::vector<ParkedPair> log;  ///< In use: the first `logged`.
  std::uint32_t logged = 0;
  std::uint32_t log_limit = 0;  ///< Stale pairs are dropped, or the log grows, when it is as long as this.
  std::uint32_t indexed = 0;    ///< Pairs in the table.
  std::uint32_t table = kNil;   ///< Of buckets.
  std::uint8_t bits = 0;        ///< 0: no table.
  bool unsorted = false;        ///< Buckets of tokens may be out of order.
  std::uint8_t tries = 0;       ///< How often the memory was plain again after it had been sparse.
  std::uint32_t saved = 0;      ///< Pairs that went without ever being tokens.
  std::uint32_t late = 0;       ///< Pairs that became tokens later.
};

struct WmeLinks {
  std::uint32_t first_item = kNil;
  std::uint32_t first_token = kNil;
  std::uint32_t next = kNil, previous = kNil;  ///< All elements in the match, newest first.
  std::uint64_t serial = 0;                    ///< Of its arrival, then of its departure.
  bool in_match = false;
  bool unsorted = false;  ///< The list of its tokens may be out of order.
};
static_assert(sizeof(WmeLinks) == 32, "elements are addressed by a shift");

/// A token that a path blocks, and a token on the path's way down.
struct OwnerAndPath {
  std::uint32_t owner = kNil;
  std::uint32_t prefix = kNil;
  std::uint32_t path = kNil;
  std::uint32_t place = 0;    ///< Breaks ties.
  std::uint32_t node = kNil;  ///< The owner's.
  std::uint64_t serial = 0;   ///< The owner's.
  std::uint64_t due = 0;      ///< To be opened: tokens that are younger than this go first.
};

/// The contents of one agent's Rete and the algorithms on it, file by file: rete_match (additions), rete_join
/// (joins and memories), rete_sparse (memories that park pairs), rete_shared (conjunctions that tokens share),
/// rete_guard (justifications with negations), rete_remove, rete_build (rules), rete_query, rete_check.
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
  std::function<void(ProductionId)> on_mixed_support;
  bool mixed_is_o = false;  ///< See Rete::MixedSupportIsO.

  RecordArray<Token> tokens;
  std::uint32_t free_tokens = kNil;
  std::uint64_t next_serial = 1;
  RecordArray<ParkedPair> parked;  ///< Indexed ones.
  std::uint32_t free_parked = kNil;
  std::vector<std::unique_ptr<SparseState>> sparse;  ///< Those of removed memories are used again.
  std::vector<std::uint32_t> free_sparse;
  std::vector<std::uint32_t> becoming_sparse;  ///< Memories that are to change when the element is in.
  std::vector<std::uint32_t> becoming_plain;
  std::array<std::uint32_t, 8> threshold;        ///< By number of tries: the score that makes a memory sparse.
  std::vector<std::uint32_t> gathered, sorting;  ///< Scratch: tokens that an element joins with; a list to be sorted.
  RecordArray<AlphaItem> items;
  std::uint32_t free_items = kNil;
  PlainVector<AlphaState> alphas;
  PlainVector<NodeState> nodes;
  PlainVector<NodeMarks> marks;  ///< Of each node.
  /// Of right-linked nodes of busy alpha memories: the identifier that an element must have to join, because the node's
  /// memory has one token; 0: that is not known. Empty while no alpha memory is busy.
  std::vector<std::uint32_t> only_id;
  std::uint32_t busy_from = 32;  ///< See Rete::BusyFrom.
  std::vector<WmeLinks> links;
  std::uint32_t newest_wme = kNil;
  std::uint32_t wme_count = 0;
  TablePool tables;
  std::uint64_t last_timetag = 0;
  std::uint32_t most_partial_matches = 0xFFFFFFFFu;
  bool log_at_limit = false;      ///< A sparse memory met this limit.
  bool abandoned = false;         ///< There are no tokens any more, whatever matches.
  std::uint32_t removing = kNil;  ///< The element that RemoveWme works on.
  std::vector<WmeId> elements;    ///< Scratch for a new match.
  /// Of a rule whose support depends on its matches: the operator that all of them test, while goals do not change.
  struct SharedOperator {
    Symbol selected;  ///< None: they differ, or it is not known.
    std::uint32_t goals_removed = 0;
    bool none_has_a_say = false;  ///< None of the matches tests an operator of its goal.
  };
  std::vector<SharedOperator> shared_operators;  ///< By rule, as far as one has matched.
  std::vector<std::uint32_t> excised;            ///< Rules excised whose last match may not be released yet.
  std::vector<ProductionPtr> retired;            ///< By number: excised rules, until the number is used again.
  bool excising = false;
  std::vector<std::uint32_t> free_rules;       ///< Free rule numbers, last freed last.
  std::unique_ptr<class ReteBuilder> builder;  ///< Keeps its scratch memory from rule to rule.
  // Shared conjunctions (rete_shared.cpp).
  bool share_conjunctions = true;                ///< See Rete::ShareConjunctions.
  bool shares_conjunctions = false;              ///< There are some, or have been.
  std::uint32_t last_owner = kNil;               ///< That was made.
  std::vector<std::uint32_t> new_paths;          ///< Paths whose owners are still to be blocked.
  std::vector<OwnerAndPath> pairings, openings;  ///< Scratch.
  bool path_element = false;                     ///< The element that RemoveWme works on may be part of a path.
  std::uint64_t arrival_of_removing = 0;         ///< WmeLinks::serial of it before it left.
  // While a new rule is matched for the first time:
  std::uint32_t refracting_node = kNil;
  std::span<const WmeId> refracted;
  InstantiationId refracting_instantiation = InstantiationId::kNone;
  MatchId refracted_match = MatchId::kNone;

  // rete_match.cpp
  void AddWme(std::uint32_t wme);
  void AddItem(std::uint32_t alpha, std::uint32_t wme);
  void Emit(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void Left(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  void LeftMemory(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  bool LinkJoin(std::uint32_t node);
  void LinkOnlyJoin(std::uint32_t memory, std::uint32_t join);
  [[gnu::noinline]] void LeftNegative(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  [[gnu::noinline]] void LeftConjunctive(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  [[gnu::noinline]] void LeftPartner(std::uint32_t node, std::uint32_t token, std::uint32_t wme);
  bool SupportByMatches(std::uint32_t node, const RuleInfo& rule, const MatchSet::Arrival& arrival);
  void LowestGoal(const RuleInfo& rule, std::span<const WmeId> matched, Symbol& goal, GoalLevel& level) const;
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
  void GrowBuckets(std::uint32_t node);
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
  void RemoveTokenOfElement(std::uint32_t token);
  void RemoveResult(std::uint32_t token);
  void RemoveSubtree(std::uint32_t token);
  void MemoryEmptied(std::uint32_t node);
  void RemoveRareLeaf(std::uint32_t token);
  void RemoveFromBucket(std::uint32_t node, std::uint32_t token);
  void UnlinkToken(std::uint32_t token);
  void FreeToken(std::uint32_t token);
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
  void JoinSparsely(std::uint32_t node, std::uint32_t parent, std::uint32_t wme, std::uint64_t serial,
                    struct KeyParts key, std::uint32_t item);
  void JoinFrom(std::uint32_t join, const Node& node, std::uint32_t token, KeyParts key, std::uint32_t item);
  void JoinSparse(const Node& join, const class RightSide& right, std::uint32_t token, const KeyParts& key,
                  std::uint32_t item);
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
  void MakeRoomToPark(SparseState & memory);
  void IndexParked(SparseState & memory);
  void GrowParkedTable(SparseState & memory, std::size_t more);
  void GatherParked(std::uint32_t join, std::uint32_t wme, std::uint32_t key);
  std::uint32_t Unpark(std::uint32_t node, const ParkedPair& pair);
  bool IsStale(const ParkedPair& pair) const {
    return pair.serial < tokens[pair.parent].forgotten || pair.serial < links[pair.wme].serial;
  }
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
  void SortByAge(std::vector<std::uint32_t> & list) const;
  void SortChildren(std::uint32_t token);
  void SortTokensOf(std::uint32_t wme);
  void SortBucket(std::uint32_t & head);
  SparseState& SparseOf(std::uint32_t node) {
    return *sparse[nodes[node].place];
  }
  const SparseState& SparseOf(std::uint32_t node) const {
    return *sparse[nodes[node].place];
  }
  bool CanBeSparse(std::uint32_t node) const;
  // The score of a memory that may become sparse: the number of its tries in the lowest bits, above them its points.
  // On others it is kNil.
  static constexpr std::uint32_t kTryBits = 3;
  static constexpr std::uint32_t kTryMask = (1u << kTryBits) - 1;
  /// See Rete::ParkAfter. Each try makes a memory sixteen times as patient.
  void ParkAfter(std::uint32_t matches) {
    for (std::uint32_t tries = 0; tries <= kTryMask; ++tries) {
      const std::uint64_t points = std::min(std::uint64_t{matches} << (4 * tries), (std::uint64_t{1} << 29) - 2);
      threshold[tries] = static_cast<std::uint32_t>(points) << kTryBits | tries;
    }
  }
  /// A pair has become a token of a memory that may become sparse, and did or did not join.
  void AddToScore(std::uint32_t & score, std::uint32_t node, std::uint32_t token) {
    if (tokens[token].first_child != kNil) {
      LowerScore(score, 3);
    } else {
      score += 1u << kTryBits;
      if (score == threshold[score & kTryMask]) {
        becoming_sparse.push_back(node);
      }
    }
  }
  static void LowerScore(std::uint32_t & score, std::uint32_t weight) {
    score -= std::min(score & ~kTryMask, weight << kTryBits);
  }
  // rete_shared.cpp
  void LeftShared(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void LeftPath(std::uint32_t node, std::uint32_t parent, std::uint32_t wme);
  void OwnerGone(std::uint32_t anchor);
  bool Pairs(std::uint32_t owner, std::uint32_t path) const;
  void BlockOwners(std::uint32_t above);
  std::uint32_t AnchorOf(std::uint32_t token) const;
  bool CameWithElement(const Token& token) const;
  OwnerAndPath Meeting(std::uint32_t owner, std::uint32_t prefix) const;
  bool CameLater(const OwnerAndPath& a, const OwnerAndPath& b) const;
  void RemoveTokensInOrder(std::uint32_t wme);
  bool IsInPath(const Token& token) const;
  void FindOpenings(std::uint32_t wme);
  void OpenOwner(const OwnerAndPath& opening);
  std::vector<std::uint32_t> OwnersOf(std::uint32_t conjunctive, std::uint32_t join, std::uint32_t parent,
                                      std::uint32_t wme) const;
  bool Holds(std::uint32_t token, std::uint32_t wme) const;
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
  std::uint32_t TakeRuleNumber();
  /// That was taken last and is not used.
  void GiveBackRuleNumber(std::uint32_t number) {
    if (number < network->rule_limit()) {
      free_rules.push_back(number);
    }
  }

  // rete_query.cpp
  using Emission = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Emission> Emissions(std::uint32_t node) const;
  std::vector<std::uint32_t> TokensByAge(std::uint32_t node) const;
  std::size_t CountTokens() const;
  template <typename Visit>
  void ForEachToken(std::uint32_t node, Visit && visit) const {
    const std::uint32_t head = nodes[node].head;
    const std::uint32_t bits = marks[node].bits();
    for (std::uint32_t n = 0; n < 1u << bits; ++n) {
      std::uint32_t token = bits == 0 ? head : tables[head + n];
      while (token != kNil) {
        const std::uint32_t next = tokens[token].next_in_bucket;
        visit(token);
        token = next;
      }
    }
  }

  /// The highest `bits` bits (1 to 31) of a product.
  static std::uint32_t Hash(std::uint32_t key, std::uint32_t bits) {
    return (key * 0x9E3779B1u) >> ((0u - bits) & 31u);
  }
  static std::uint32_t PairKey(std::uint32_t id, std::uint32_t value) {
    return (id * 0x85EBCA6Bu) ^ (value * 0xC2B2AE35u);
  }
  static std::uint32_t FieldOf(const Wme& wme, Field field) {
    return kernel::FieldOf(wme, field).bits();
  }
  GoalLevel GoalLevelOf(Symbol id) const {
    return id.IsIdentifier() && id.index() < goals.level_of_goal.size() ? goals.level_of_goal[id.index()]
                                                                        : GoalLevel{0};
  }
  std::uint64_t LtiOf(Symbol id) const {
    return id.IsIdentifier() && id.index() < goals.lti_of.size() ? goals.lti_of[id.index()] : 0;
  }
};

}  // namespace soarbox::kernel
