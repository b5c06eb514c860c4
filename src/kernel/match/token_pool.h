// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/match/element_links.h"
#include "kernel/match/network.h"
#include "kernel/match/record_array.h"
#include "kernel/match/rete.h"

namespace soarbox::kernel {

/// A partial match at a node, or a blocking result. The tokens of a parent form a list, newest first; so do the tokens
/// with the same element. Kinds, by node:
///
/// * memory, negative, conjunctive: it is in a bucket of its node's memory (by `key`).
/// * result of a negative node (kResultBit set): child of the negative token that it blocks; in no bucket. A blocked
///   token has results as children, an open one has tokens of later nodes: never both.
/// * partner: a result inside a conjunction; child of the token above it. It is also in the list of results of the
///   conjunctive token `key`. This token is blocked (kBlockedBit) while it has results; then its `first_child` is that
///   list.
/// * shared conjunctive: it is in its node's memory; `pairs` is its anchor. Blocked likewise; a result is a child of
///   the path that blocks it and has no element.
/// * anchor: has no parent and no element; `key` is the identifier, `previous_sibling` counts its owners.
/// * production, guard: `key` is the match.
/// * kFixedMatchNode: `parent` is kNil, `key` the match, `next_in_bucket` links the match's other tokens. Of a guarded
///   rule (rete_guard.cpp): `previous_in_bucket` is kGuarded, `key` the guard.
///
/// A token created late from a parked pair is at the wrong place in its lists. Then kUnsortedBit of the parent and
/// WmeLinks::unsorted are set: the list must be sorted by serial number before its order matters.
struct Token {
  std::uint32_t parent;
  std::uint32_t wme;
  std::uint32_t node;
  std::uint32_t first_child;
  std::uint32_t next_sibling, previous_sibling;
  std::uint32_t next_of_wme, previous_of_wme;
  std::uint32_t next_in_bucket, previous_in_bucket;
  std::uint32_t key;
  std::uint32_t pairs;      ///< Memory above a sparse one: number of this token's pairs in the sparse memory, else 0.
  std::uint64_t serial;     ///< Running number of the arrival of the token (or of the parked pair that it was) at its
                            ///< node.
  std::uint64_t forgotten;  ///< When a token with parked pairs last freed this record; pairs that are older are stale.

  static constexpr std::uint32_t kResultBit = 0x80000000u;
  static constexpr std::uint32_t kBlockedBit = 0x40000000u;
  static constexpr std::uint32_t kUnsortedBit = 0x20000000u;
  static constexpr std::uint32_t kNodeMask = 0x1FFFFFFFu;
  static constexpr std::uint32_t kFixedMatchNode = 0x1FFFFFFFu;
  static constexpr std::uint32_t kGuarded = 0;  ///< Else kNil.
};
static_assert(sizeof(Token) == Rete::kTokenBytes);

/// All tokens of an agent, their lists by parent and by element, and the running numbers that record the order of
/// arrival.
///
/// Invariants: a token is on the list of its parent and on that of its element, if it has them; a free record has no
/// pairs.
class [[gnu::visibility("hidden")]] TokenPool {
 public:
  Token& operator[](std::uint32_t token) {
    return records_[token];
  }
  const Token& operator[](std::uint32_t token) const {
    return records_[token];
  }
  Records<Token> records() {
    return records_.records();
  }
  Records<const Token> records() const {
    return records_.records();
  }
  Records<const Token> read() const {
    return records_.records();
  }

  std::uint64_t next_serial() const {
    return next_serial_;
  }
  std::uint64_t TakeSerial() {
    return next_serial_++;
  }
  /// The record of a token above a sparse memory is about to be freed: its parked pairs become stale.
  void ForgetPairs(Token & token) {
    token.forgotten = last_forgotten_ = next_serial_;
  }
  /// The next serial number at the last call of ForgetPairs.
  std::uint64_t last_forgotten() const {
    return last_forgotten_;
  }
  void set_next_serial(std::uint64_t serial) {
    next_serial_ = serial;
  }

  /// Allocates a record for a new token. Sets everything except its bucket and its key.
  [[gnu::always_inline]] std::uint32_t Make(ElementLinks & elements, std::uint32_t node, std::uint32_t parent,
                                            std::uint32_t wme, std::uint64_t serial) {
    std::uint32_t index = free_;
    if (index != kNil) [[likely]] {
      free_ = records_[index].next_sibling;
    } else {
      index = records_.Append();
      records_[index].pairs = 0;
      records_[index].forgotten = 0;
    }
    const Records<Token> all = records_.records();
    Token& token = all[index];
    token.parent = parent;
    token.wme = wme;
    token.node = node;
    token.serial = serial;
    token.first_child = kNil;
    token.previous_sibling = kNil;
    std::uint32_t sibling = kNil;
    if (parent != kNil) [[likely]] {
      sibling = all[parent].first_child;
      all[parent].first_child = index;
      if (sibling != kNil) {
        all[sibling].previous_sibling = index;
      }
    }
    token.next_sibling = sibling;
    token.previous_of_wme = kNil;
    std::uint32_t other = kNil;
    if (wme != kNil) [[likely]] {
      std::uint32_t& head = elements[wme].first_token;
      other = head;
      head = index;
      if (other != kNil) {
        all[other].previous_of_wme = index;
      }
    }
    token.next_of_wme = other;
    return index;
  }
  [[gnu::always_inline]] std::uint32_t Make(ElementLinks & elements, std::uint32_t node, std::uint32_t parent,
                                            std::uint32_t wme) {
    return Make(elements, node, parent, wme, next_serial_++);
  }

  /// Removes a token from its element's list.
  [[gnu::always_inline]] static void UnlinkFromElement(ElementLinks & elements, Records<Token> all,
                                                       const Token& token) {
    if (token.wme != kNil) [[likely]] {
      const std::uint32_t next = token.next_of_wme;
      const std::uint32_t previous = token.previous_of_wme;
      if (next != kNil) {
        all[next].previous_of_wme = previous;
      }
      (previous != kNil ? all[previous].next_of_wme : elements[token.wme].first_token) = next;
    }
  }
  void UnlinkFromParent(const Token& token) {
    if (token.parent != kNil) {
      const Records<Token> all = records_.records();
      if (token.next_sibling != kNil) {
        all[token.next_sibling].previous_sibling = token.previous_sibling;
      }
      (token.previous_sibling != kNil ? all[token.previous_sibling].next_sibling : all[token.parent].first_child) =
          token.next_sibling;
    }
  }
  /// Removes a token from the lists of its parent and its element.
  void Unlink(ElementLinks & elements, std::uint32_t token);
  /// Frees all results of a blocked conjunctive token.
  void FreeResults(ElementLinks & links, std::uint32_t owner);
  /// Frees the record of a token, which must be in no list.
  [[gnu::always_inline]] void Free(Token & token, std::uint32_t index) {
    token.next_sibling = free_;
    free_ = index;
  }
  [[gnu::always_inline]] void Free(std::uint32_t index) {
    Free(records_[index], index);
  }

  /// Sorts a list, newest first.
  void SortByAge(std::vector<std::uint32_t> & list) const;
  void SortChildren(std::uint32_t parent);
  void SortTokensOf(WmeLinks & element);
  /// `head` is that of a bucket.
  void SortBucket(std::uint32_t & head);

  /// The topmost ancestor of a token.
  std::uint32_t TopOf(std::uint32_t token) const;
  /// Whether an element belongs to a token or its ancestors; the topmost token has none.
  bool Holds(std::uint32_t token, std::uint32_t wme) const;

  std::size_t CountInUse() const;
  /// Calls visit(token) for each free record.
  template <typename Visit>
  void ForEachFree(Visit && visit) const {
    for (std::uint32_t token = free_; token != kNil; token = records_[token].next_sibling) {
      visit(token);
    }
  }
  void SetLimit(std::size_t most) {
    records_.SetLimit(most);
  }
  bool at_limit() const {
    return records_.at_limit();
  }
  /// Frees all memory.
  void Release() {
    records_.Release();
    free_ = kNil;
  }
  std::size_t MemoryBytes() const {
    return records_.MemoryBytes();
  }

 private:
  RecordArray<Token> records_;
  std::uint32_t free_ = kNil;
  std::uint64_t next_serial_ = 1;
  std::uint64_t last_forgotten_ = 0;
  std::vector<std::uint32_t> sorting_;  ///< Scratch: a list to be sorted.
};

/// The element bound `levels` steps up from a token.
inline std::uint32_t ElementAt(Records<const Token> tokens, std::uint32_t token, std::uint32_t levels) {
  while (levels-- > 0) {
    token = tokens[token].parent;
  }
  return tokens[token].wme;
}

/// The element bound `levels` steps up from the token that represents, or would represent, (parent, wme).
inline std::uint32_t ElementAt(Records<const Token> tokens, std::uint32_t parent, std::uint32_t wme,
                               std::uint32_t levels) {
  return levels == 0 ? wme : ElementAt(tokens, parent, levels - 1);
}

}  // namespace soarbox::kernel
