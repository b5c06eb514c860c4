// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/node_states.h"

#include <algorithm>

namespace soarbox::kernel {

void NodeStates::MakeRoom(std::size_t count) {
  while (states_.size() < count) {
    marks_.emplace_back();
    states_.emplace_back();
  }
}

void NodeStates::Reset(std::uint32_t node) {
  if (marks_[node].bits() != 0) {
    tables_.Free(states_[node].head, marks_[node].bits());
  }
  states_[node] = NodeState();
  marks_[node] = NodeMarks();
}

// Tokens --------------------------------------------------------------------------------------------------------------

/// If tokens have few different keys, a larger table would not shorten the chains.
bool NodeStates::IsWorthGrowing(std::uint32_t table, std::uint32_t bits) const {
  constexpr std::uint32_t kBucketsPerKey = 8;
  std::uint32_t used = 0;
  for (std::uint32_t n = 0; n < 1u << bits; ++n) used += tables_[table + n] != kNil ? 1 : 0;
  return used * kBucketsPerKey > 1u << bits;
}

// Each bucket is split in place, starting at the oldest token, so that tokens with equal keys stay newest first.
void NodeStates::GrowBuckets(TokenPool& tokens, std::uint32_t node) {
  // Tokens are scattered in memory: each is read once, and those of later buckets are prefetched.
  constexpr std::uint32_t kAhead = 12;
  constexpr std::uint32_t kFirstBits = 4, kMoreBits = 2;
  NodeState& state = states_[node];
  const std::uint32_t old_bits = marks_[node].bits();
  const std::uint32_t old_head = state.head;
  if (old_bits >= kBitsForAll && !IsWorthGrowing(state.head, old_bits)) return;
  const std::uint32_t bits = old_bits == 0 ? kFirstBits : old_bits + kMoreBits;
  const std::uint32_t table = tables_.Allocate(bits);
  const std::uint32_t parts = 1u << (bits - old_bits);  // The tokens of a bucket are distributed over this number of
                                                        // neighbours.
  std::uint32_t last[1u << kFirstBits];
  for (std::uint32_t n = 0; n < 1u << old_bits; ++n) {
    std::uint32_t index = old_bits == 0 ? old_head : tables_[old_head + n];
    if (old_bits != 0 && n + kAhead < 1u << old_bits) {
      const std::uint32_t ahead = tables_[old_head + n + kAhead];
      if (ahead != kNil) __builtin_prefetch(&tokens[ahead].next_in_bucket);
    }
    if (index == kNil) continue;
    std::fill_n(last, parts, kNil);
    const std::uint32_t first = table + n * parts;
    while (index != kNil) {
      Token& token = tokens[index];
      const std::uint32_t next = token.next_in_bucket;
      const std::uint32_t bucket = table + TablePool::Hash(token.key, bits);
      std::uint32_t& end = last[bucket - first];
      token.previous_in_bucket = end;
      (end != kNil ? tokens[end].next_in_bucket : tables_[bucket]) = index;
      end = index;
      index = next;
    }
    for (std::uint32_t part = 0; part < parts; ++part) {
      if (last[part] != kNil) tokens[last[part]].next_in_bucket = kNil;
    }
  }
  if (old_bits != 0) {
    tables_.Free(old_head, old_bits);
  }
  state.head = table;
  marks_[node].SetBits(bits);
}

void NodeStates::SortBuckets(TokenPool& tokens, std::uint32_t node) {
  NodeState& state = states_[node];
  const std::uint32_t bits = marks_[node].bits();
  for (std::uint32_t n = 0; n < 1u << bits; ++n) {
    tokens.SortBucket(bits == 0 ? state.head : tables_[state.head + n]);
  }
}

// Links ---------------------------------------------------------------------------------------------------------------

void NodeStates::LinkLeft(std::uint32_t join, std::uint32_t memory) {
  NodeState& state = states_[join];
  std::uint32_t& head = states_[memory].first_linked;
  state.previous_left = kNil;
  state.next_left = head;
  if (head != kNil) {
    states_[head].previous_left = join;
  }
  head = join;
  marks_[join].Set(NodeMarks::kLeftLinked);
}

void NodeStates::UnlinkLeft(std::uint32_t join, std::uint32_t memory) {
  const NodeState& state = states_[join];
  if (state.next_left != kNil) {
    states_[state.next_left].previous_left = state.previous_left;
  }
  if (state.previous_left != kNil) {
    states_[state.previous_left].next_left = state.next_left;
  } else {
    states_[memory].first_linked = state.next_left;
  }
  marks_[join].Unset(NodeMarks::kLeftLinked);
}

// Inserts before the nearest linked ancestor with the same alpha memory, else at the end. A descendant must process a
// new element before its ancestor creates tokens with it; else the descendant would process the pair twice.
void NodeStates::LinkRight(const Network& network, AlphaState& alpha, std::uint32_t node) {
  NodeState& state = states_[node];
  std::uint32_t ancestor = network.node(node).ancestor;
  while (ancestor != kNil && !marks_[ancestor].Is(NodeMarks::kRightLinked)) {
    ancestor = network.node(ancestor).ancestor;
  }
  state.next_right = ancestor;
  state.previous_right = ancestor == kNil ? alpha.last_node : states_[ancestor].previous_right;
  (ancestor == kNil ? alpha.last_node : states_[ancestor].previous_right) = node;
  (state.previous_right == kNil ? alpha.first_node : states_[state.previous_right].next_right) = node;
  marks_[node].Set(NodeMarks::kRightLinked);
}

void NodeStates::UnlinkRight(AlphaState& alpha, std::uint32_t node) {
  const NodeState& state = states_[node];
  (state.next_right == kNil ? alpha.last_node : states_[state.next_right].previous_right) = state.previous_right;
  (state.previous_right == kNil ? alpha.first_node : states_[state.previous_right].next_right) = state.next_right;
  marks_[node].Unset(NodeMarks::kRightLinked);
}

// Releasing everything ------------------------------------------------------------------------------------------------

void NodeStates::Release() {
  std::fill(states_.begin(), states_.end(), NodeState());
  std::fill(marks_.begin(), marks_.end(), NodeMarks());
  tables_ = TablePool();
}

}  // namespace soarbox::kernel
