// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernel/base/plain_vector.h"
#include "kernel/match/alpha_memories.h"
#include "kernel/match/network.h"
#include "kernel/match/table_pool.h"
#include "kernel/match/token_pool.h"

namespace soarbox::kernel {

/// A node's part of the agent's state, in the four words that this kind of node needs.
///
/// Unlinking: a join is not in its memory's list while its alpha memory is empty, and not in the alpha memory's list
/// while its memory is empty; but it is always in at least one of them. A negative node is in its alpha memory's list
/// exactly while it has tokens.
struct NodeState {
  union {
    std::uint32_t head = kNil;  ///< Tokens: the bucket if NodeMarks::bits() is 0, else a table of buckets.
    std::uint32_t next_left;    ///< Join: in its memory's list.
  };
  union {
    std::uint32_t count = 0;  ///< Tokens; for a sparse memory also parked pairs that are not stale.
    std::uint32_t previous_left;
  };
  union {
    std::uint32_t first_linked = kNil;  ///< For a memory: left-linked joins, last linked first. For a guard: the tokens
                                        ///< of its rule's elements; kNil: one has left.
    std::uint32_t next_right;           ///< Join, negative: in the alpha memory's list.
  };
  union {
    std::uint32_t previous_right = kNil;
    std::uint32_t score;  ///< Memory that is not sparse: see SparseMemories::AddToScore.
    std::uint32_t place;  ///< Sparse memory: in SparseMemories.
  };
};
static_assert(sizeof(NodeState) == 16, "nodes are addressed by a shift");

/// The small part of a node's state, in a separate array to avoid padding. It is one 16-bit number and not several
/// bytes: bytes may alias any object, so storing one would force the compiler to reload its registers.
class NodeMarks {
 public:
  // How a node relates to sparse memories (rete_sparse.cpp).
  static constexpr std::uint16_t kSparse = 0x100;       ///< It is a sparse memory.
  static constexpr std::uint16_t kAboveSparse = 0x200;  ///< Memory: its only join feeds a sparse memory.
  static constexpr std::uint16_t kFeedsSparse = 0x400;  ///< Join: its only child is a sparse memory.
  // Other properties that matter when a token is removed.
  static constexpr std::uint16_t kNegative = 0x800;  ///< It is a negative node.
  static constexpr std::uint16_t kOther = 0x1000;    ///< It is neither a negative node nor a memory.
  static constexpr std::uint16_t kUncommonEnd = kSparse | kAboveSparse | kOther;
  static constexpr std::uint16_t kInPath = 0x8000;  ///< It is part of a shared conjunction.
  // See NodeState on unlinking.
  static constexpr std::uint16_t kLeftLinked = 0x2000;   ///< Join.
  static constexpr std::uint16_t kRightLinked = 0x4000;  ///< Join, negative.

  /// True if any of these marks is set.
  bool Is(std::uint16_t mark) const { return (word_ & mark) != 0; }
  void Set(std::uint16_t mark) { word_ = static_cast<std::uint16_t>(word_ | mark); }
  void Unset(std::uint16_t mark) { word_ = static_cast<std::uint16_t>(word_ & ~mark); }

  /// The logarithm of the size of the node's table of tokens; 0: there is none.
  std::uint32_t bits() const { return word_ & 0xFFu; }
  /// For a memory: all its tokens are in one list.
  bool HasList() const { return (word_ & (0xFFu | kSparse)) == 0; }
  void SetBits(std::uint32_t bits) { word_ = static_cast<std::uint16_t>((word_ & 0xFF00u) | bits); }

 private:
  std::uint16_t word_ = 0;
};

/// An agent's part of each node: its tokens, by key, and the sides on which joins are linked.
///
/// Invariants: see NodeState on unlinking; the tokens of a bucket are newest first, except in sparse memories marked as
/// unsorted.
class [[gnu::visibility("hidden")]] NodeStates {
 public:
  NodeState& operator[](std::uint32_t node) {
    return states_[node];
  }
  const NodeState& operator[](std::uint32_t node) const {
    return states_[node];
  }
  const NodeState* data() const {
    return states_.data();
  }
  NodeMarks& marks(std::uint32_t node) {
    return marks_[node];
  }
  const NodeMarks& marks(std::uint32_t node) const {
    return marks_[node];
  }
  std::size_t size() const {
    return states_.size();
  }

  /// Makes room for at least `count` nodes.
  void MakeRoom(std::size_t count);
  /// A node has been removed: resets its state.
  void Reset(std::uint32_t node);

  // Tokens --------------------------------------------------------------------------------------------------------

  /// The first token of the bucket that holds tokens with this key (among others). `bits`: of the node's marks.
  [[gnu::always_inline]] std::uint32_t BucketHead(std::uint32_t node, std::uint32_t bits, std::uint32_t key) const {
    const std::uint32_t head = states_[node].head;
    return bits == 0 ? head : tables_[head + TablePool::Hash(key, bits)];
  }
  std::uint32_t BucketHead(std::uint32_t node, std::uint32_t key) const {
    return BucketHead(node, marks_[node].bits(), key);
  }
  /// Puts a token at the head of its bucket and grows the table with the number of tokens, which is in `counter`.
  [[gnu::always_inline]] void Insert(TokenPool & tokens, NodeState & memory, std::uint32_t node, std::uint32_t index,
                                     std::uint32_t key, bool keyed, std::uint32_t& counter) {
    const Records<Token> all = tokens.records();
    const std::uint32_t bits = marks_[node].bits();
    std::uint32_t* head = &memory.head;
    const std::uint32_t count = ++counter;
    bool grow = false;
    if (bits != 0) {
      head = &tables_[memory.head + TablePool::Hash(key, bits)];
      grow = (count >> bits) != 0 && MayGrow(bits, count);
    } else {
      grow = count > kTinyMemory && keyed;
    }
    const std::uint32_t next = *head;
    *head = index;
    all[index].key = key;
    all[index].previous_in_bucket = kNil;
    all[index].next_in_bucket = next;
    if (next != kNil) {
      all[next].previous_in_bucket = index;
    }
    if (grow) [[unlikely]] {
      GrowBuckets(tokens, node);
    }
  }
  [[gnu::always_inline]] void Insert(TokenPool & tokens, std::uint32_t node, std::uint32_t index, std::uint32_t key,
                                     bool keyed) {
    NodeState& memory = states_[node];
    Insert(tokens, memory, node, index, key, keyed, memory.count);
  }
  /// The same for nodes that never have a table.
  [[gnu::always_inline]] static void InsertInList(TokenPool & tokens, NodeState & memory, std::uint32_t index,
                                                  std::uint32_t key) {
    const Records<Token> all = tokens.records();
    const std::uint32_t next = memory.head;
    memory.head = index;
    ++memory.count;
    all[index].key = key;
    all[index].previous_in_bucket = kNil;
    all[index].next_in_bucket = next;
    if (next != kNil) {
      all[next].previous_in_bucket = index;
    }
  }
  /// Removes a token from its bucket. The caller updates the count.
  [[gnu::always_inline]] void UnlinkFromBucket(Records<Token> all, std::uint32_t node, const Token& token) {
    const std::uint32_t next = token.next_in_bucket;
    const std::uint32_t previous = token.previous_in_bucket;
    if (next != kNil) {
      all[next].previous_in_bucket = previous;
    }
    if (previous != kNil) {
      all[previous].next_in_bucket = next;
    } else {
      std::uint32_t& head = states_[node].head;
      const std::uint32_t bits = marks_[node].bits();
      (bits == 0 ? head : tables_[head + TablePool::Hash(token.key, bits)]) = next;
    }
  }
  void RemoveFromBucket(TokenPool & tokens, std::uint32_t node, std::uint32_t token) {
    UnlinkFromBucket(tokens.records(), node, tokens[token]);
    --states_[node].count;
  }
  /// Calls visit(token) for the tokens of a node; visit may remove them.
  template <typename Visit>
  void ForEachToken(const TokenPool& tokens, std::uint32_t node, Visit&& visit) const {
    const std::uint32_t head = states_[node].head;
    const std::uint32_t bits = marks_[node].bits();
    for (std::uint32_t n = 0; n < 1u << bits; ++n) {
      std::uint32_t token = bits == 0 ? head : tables_[head + n];
      while (token != kNil) {
        const std::uint32_t next = tokens[token].next_in_bucket;
        visit(token);
        token = next;
      }
    }
  }
  /// Sorts the tokens of all buckets.
  void SortBuckets(TokenPool & tokens, std::uint32_t node);

  // Links ---------------------------------------------------------------------------------------------------------

  /// Adds a join to the list of its memory, or removes it.
  void LinkLeft(std::uint32_t join, std::uint32_t memory);
  void UnlinkLeft(std::uint32_t join, std::uint32_t memory);
  /// The same for a join or a negative node and its alpha memory.
  void LinkRight(const Network& network, AlphaState& alpha, std::uint32_t node);
  void UnlinkRight(AlphaState & alpha, std::uint32_t node);

  /// Frees all memory: no node has tokens, and none is linked.
  void Release();
  void ShrinkToFit() {
    states_.shrink_to_fit();
    marks_.shrink_to_fit();
  }
  std::size_t MemoryBytes() const {
    return states_.capacity() * sizeof(NodeState) + marks_.capacity() * sizeof(NodeMarks) + tables_.MemoryBytes();
  }

 private:
  /// A table with fewer bits grows as soon as it has as many tokens as buckets. A larger table is checked each time the
  /// number of its tokens has doubled.
  static constexpr std::uint32_t kBitsForAll = 8;
  static bool MayGrow(std::uint32_t bits, std::uint32_t count) {
    return bits < kBitsForAll || (count & (count - 1)) == 0;
  }
  void GrowBuckets(TokenPool & tokens, std::uint32_t node);
  bool IsWorthGrowing(std::uint32_t table, std::uint32_t bits) const;

  PlainVector<NodeState> states_;
  PlainVector<NodeMarks> marks_;
  TablePool tables_;
};

}  // namespace soarbox::kernel
