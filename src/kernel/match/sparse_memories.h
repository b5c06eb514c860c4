// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "kernel/match/element_links.h"
#include "kernel/match/record_array.h"
#include "kernel/match/table_pool.h"
#include "kernel/match/token_pool.h"

namespace soarbox::kernel {

/// A pair that reached a sparse memory and joins with nothing (rete_sparse.cpp). It is stale after its token or its
/// element has left. Their records may belong to others then.
struct ParkedPair {
  std::uint32_t parent;
  std::uint32_t wme;
  std::uint64_t serial;
  std::uint32_t key;   ///< As in a token.
  std::uint32_t next;  ///< In its bucket, or in the free list.
};

/// Pairs of one token with consecutive elements of its bucket, newest first, that joined with nothing when the token
/// arrived. Stale after the token has left. An element that has left is no longer in the bucket.
struct ParkedRun {
  std::uint32_t parent;
  std::uint32_t count;           ///< The initial number; the run owns this number of serial numbers.
  std::uint64_t serial;          ///< Serial number of the first pair.
  std::uint64_t newest, oldest;  ///< Arrival of the first and of the last element.
};

/// For vectors whose records are written before they are read: does not initialize memory.
template <typename T>
struct UnsetAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  template <typename U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// The other state of a sparse memory. Pairs are parked in a log; when the first element arrives from the right, they
/// are moved to a hash table.
struct SparseState {
  std::uint32_t node = kNil;
  std::uint32_t tokens = 0;                                 ///< Pairs that are tokens.
  std::vector<ParkedPair, UnsetAllocator<ParkedPair>> log;  ///< Only the first `logged` are in use.
  std::uint32_t logged = 0;
  std::uint32_t log_limit = 0;  ///< At this length, stale pairs are dropped or the log grows.
  std::vector<ParkedRun> runs;
  std::size_t run_limit = 0;   ///< Likewise.
  std::uint32_t indexed = 0;   ///< Pairs in the table.
  std::uint32_t table = kNil;  ///< Of buckets.
  std::uint8_t bits = 0;       ///< 0: no table.
  bool unsorted = false;       ///< Buckets of tokens may be out of order.
  std::uint8_t tries = 0;      ///< How often the memory became sparse and then plain again.
  std::uint32_t saved = 0;     ///< Number of pairs that left without ever being tokens.
  std::uint32_t late = 0;      ///< Number of pairs that became tokens later.
};

/// The parked pairs of an agent's sparse memories, and the scores that make memories sparse or plain.
///
/// Without sparse memories, column-sums takes 42 % more instructions, join-heavy 7 %, big-memory 5 % and sliding-search
/// 3 %; rl-grid takes 1 % fewer. rete_random_test.cpp compares both kinds of memories with a naive matcher.
///
/// Invariants: a pair that is not stale is either in the log or in the table of its memory; pairs in the table are
/// counted.
class [[gnu::visibility("hidden")]] SparseMemories {
 public:
  /// Whether a memory may be sparse at all. It must have a key. It must form a chain of only children with the joins
  /// above and below it. The results of these joins' tests must not change while the elements exist.
  static bool CanBeSparse(const Network& net, std::uint32_t index);

  SparseState& operator[](std::uint32_t place) {
    return *states_[place];
  }
  const SparseState& operator[](std::uint32_t place) const {
    return *states_[place];
  }
  /// Allocates a place for a memory that becomes sparse.
  std::uint32_t Take();
  /// Frees the place of a memory that is plain again and has no table any more.
  void GiveBack(std::uint32_t place);

  // Pairs ---------------------------------------------------------------------------------------------------------

  static bool IsStale(const TokenPool& tokens, const ElementLinks& elements, const ParkedPair& pair) {
    return pair.serial < tokens[pair.parent].forgotten || pair.serial < elements[pair.wme].serial;
  }
  static bool IsStale(const TokenPool& tokens, const ParkedRun& run) {
    return run.serial < tokens[run.parent].forgotten;
  }
  void Park(const TokenPool& tokens, SparseState& memory, const ParkedRun& run) {
    if (memory.runs.size() == memory.run_limit) [[unlikely]] {
      MakeRoomForRuns(tokens, memory);
    }
    memory.runs.push_back(run);
  }
  /// Drops stale pairs from a full log, and grows it if too many remain.
  void MakeRoomToPark(const TokenPool& tokens, const ElementLinks& elements, SparseState& memory);
  /// Moves the log into the table.
  void Index(const TokenPool& tokens, const ElementLinks& elements, SparseState& memory);
  /// Removes the pairs with a key from the table for which `leaves(pair)` is true.
  template <typename Leaves>
  void TakePairs(SparseState & memory, std::uint32_t key, Leaves && leaves) {
    std::uint32_t previous = kNil;
    const std::uint32_t bucket = memory.table + TablePool::Hash(key, memory.bits);
    for (std::uint32_t index = tables_[bucket]; index != kNil;) {
      const ParkedPair& pair = parked_[index];
      const std::uint32_t next = pair.next;
      if (pair.key == key && leaves(pair)) {
        (previous != kNil ? parked_[previous].next : tables_[bucket]) = next;
        Free(index);
        --memory.indexed;
      } else {
        previous = index;
      }
      index = next;
    }
  }
  /// Calls visit(pair) for all pairs in the table, then drops the table.
  template <typename Visit>
  void TakeTable(SparseState & memory, Visit && visit) {
    for (std::uint32_t n = 0; n < 1u << memory.bits; ++n) {
      for (std::uint32_t index = tables_[memory.table + n]; index != kNil;) {
        const std::uint32_t next = parked_[index].next;
        visit(parked_[index]);
        Free(index);
        index = next;
      }
    }
    tables_.Free(memory.table, memory.bits);
  }
  /// Calls visit(pair) for all pairs in the table.
  template <typename Visit>
  void ForEachIndexed(const SparseState& memory, Visit&& visit) const {
    for (std::uint32_t n = 0; memory.bits != 0 && n < 1u << memory.bits; ++n) {
      for (std::uint32_t index = tables_[memory.table + n]; index != kNil; index = parked_[index].next) {
        visit(parked_[index]);
      }
    }
  }

  // Scores --------------------------------------------------------------------------------------------------------

  // The score of a memory that may become sparse: the lowest bits contain the number of its tries, the others its
  // points. For other memories it is kNil.
  static constexpr std::uint32_t kTryBits = 3;
  static constexpr std::uint32_t kTryMask = (1u << kTryBits) - 1;
  /// See Rete::ParkAfter. Each try makes the threshold of a memory sixteen times larger.
  void ParkAfter(std::uint32_t matches) {
    for (std::uint32_t tries = 0; tries <= kTryMask; ++tries) {
      const std::uint64_t points = std::min(std::uint64_t{matches} << (4 * tries), (std::uint64_t{1} << 29) - 2);
      threshold_[tries] = static_cast<std::uint32_t>(points) << kTryBits | tries;
    }
  }
  /// A pair has become a token of a memory that may become sparse. `joined`: it joined with an element.
  void AddToScore(std::uint32_t & score, std::uint32_t node, bool joined) {
    if (joined) {
      LowerScore(score, 3);
    } else {
      score += 1u << kTryBits;
      if (score == threshold_[score & kTryMask]) {
        becoming_sparse_.push_back(node);
      }
    }
  }
  static void LowerScore(std::uint32_t & score, std::uint32_t weight) {
    score -= std::min(score & ~kTryMask, weight << kTryBits);
  }
  /// `count` pairs of a sparse memory became tokens late. This is expensive, so the memory may have to become plain.
  void CountLate(SparseState & memory, std::size_t count);
  /// Whether memories are to be converted after the current element has been added.
  bool HasChanges() const {
    return !becoming_sparse_.empty() || !becoming_plain_.empty();
  }
  std::vector<std::uint32_t>& becoming_sparse() {
    return becoming_sparse_;
  }
  std::vector<std::uint32_t>& becoming_plain() {
    return becoming_plain_;
  }

  // All of them ---------------------------------------------------------------------------------------------------

  /// Limits the pairs in each log, the runs of each memory, and the pairs in all tables together.
  void SetLimit(std::uint32_t most);
  /// True if one of them reached the limit.
  bool at_limit() const {
    return log_at_limit_ || parked_.at_limit();
  }
  /// Calls visit(state) for the states in use.
  template <typename Visit>
  void ForEach(Visit && visit) const {
    for (const auto& state : states_) {
      if (state->node != kNil) {
        visit(*state);
      }
    }
  }
  /// Frees all memory.
  void Release();
  std::size_t MemoryBytes() const;

 private:
  void MakeRoomForRuns(const TokenPool& tokens, SparseState& memory);
  void GrowTable(const TokenPool& tokens, const ElementLinks& elements, SparseState& memory, std::size_t more);
  void Free(std::uint32_t index) {
    parked_[index].next = free_parked_;
    free_parked_ = index;
  }

  std::vector<std::unique_ptr<SparseState>> states_;  ///< States of memories that became plain are reused.
  std::vector<std::uint32_t> free_;
  RecordArray<ParkedPair> parked_;  ///< Pairs in tables.
  std::uint32_t free_parked_ = kNil;
  TablePool tables_;
  std::vector<std::uint32_t> becoming_sparse_, becoming_plain_;
  std::array<std::uint32_t, kTryMask + 1> threshold_{};  ///< By number of tries: the score that makes a memory sparse.
  std::uint32_t most_ = 0xFFFFFFFFu;
  bool log_at_limit_ = false;
};

}  // namespace soarbox::kernel
