// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/match/join_pairs.h"

/// How several pairs reach a sparse memory (rete_sparse.cpp).
namespace soarbox::kernel {

/// In which of their elements the pairs of a source may differ: up to which level above the pair.
enum class Differ : std::uint32_t {
  kElements = 1,  ///< All pairs have the same token.
  kSiblings = 2,  ///< Their tokens have the same parent.
  kAll = 0xFFFFFFFFu
};

/// The next pair of a source, which may take serial numbers for tokens.
template <typename Source>
[[gnu::always_inline]] inline bool NextPair(ReteState& state, Source& source, std::uint64_t& serial,
                                            std::uint32_t& parent, std::uint32_t& wme) {
  if constexpr (!Source::kMakesTokens) {
    return source.Next(parent, wme);
  }
  state.tokens.set_next_serial(serial);
  const bool is_pair = source.Next(parent, wme);
  serial = state.tokens.next_serial();
  return is_pair;
}

/// Passes pairs to a sparse memory. Most pairs end here: they are parked after one look-up on the other side.
/// Everything that is the same for all pairs is computed once. `source.Next(parent, wme)` returns the next pair, or
/// false after the last one; there must be at least one.
template <Differ differ, KeyKind kind, typename Source>
[[gnu::always_inline]] inline void AddPairsOf(ReteState& state, std::uint32_t index, const RightSide& right,
                                              Source source) {
  const Network& net = *state.network;
  const Node& node = net.node(index);
  const Node& joined = net.node(node.first_child);
  const std::uint32_t id_levels = node.key_id_levels;
  const std::uint32_t value_levels = node.key_value_levels;
  const Field id_field = node.key_id_field;
  const Field value_field = node.key_value_field;
  const Wme* const wmes = state.wmes.data();
  NodeState& memory = state.nodes[index];
  SparseState& sparse = state.sparse[memory.place];
  const bool tested = joined.test_count != 0;
  constexpr auto kDiffering = static_cast<std::uint32_t>(differ);
  constexpr bool kOneParent = differ == Differ::kElements;

  std::uint32_t parent = kNil;
  std::uint32_t wme = kNil;
  source.Next(parent, wme);
  KeyParts key;
  std::uint64_t serial = state.tokens.next_serial();
  ParkedPair* log = sparse.log.data() + sparse.logged;
  ParkedPair* end = sparse.log.data() + sparse.log_limit;
  std::uint32_t arrived = 0;
  bool first = true;
  do {
    const Records<Token> tokens = state.tokens.records();
    if (id_levels == 0) {
      key.id = BitsOf(wmes[wme], id_field);
    } else if (id_levels < kDiffering || first) {
      key.id = BitsOf(wmes[ElementAt(state.tokens.read(), parent, id_levels - 1u)], id_field);
    }
    if (kind == KeyKind::kId) {
      key.key = key.id;
    } else {
      if (value_levels == 0) {
        key.value = BitsOf(wmes[wme], value_field);
      } else if (value_levels < kDiffering || first) {
        key.value = BitsOf(wmes[ElementAt(state.tokens.read(), parent, value_levels - 1u)], value_field);
      }
      key.key = PairKey(key.id, key.value);
    }
    first = false;
    if (!kOneParent) {
      ++tokens[parent].pairs;
    }
    ++arrived;
    const std::uint64_t now = serial++;
    std::uint32_t item = right.FirstOf<kind>(key);
    if (item != kNil && tested) {
      item = FirstPassingOf(state, right, joined, key, parent, wme, item);
    }
    if (item == kNil && log != end) [[likely]] {
      log->parent = parent;
      log->wme = wme;
      log->serial = now;
      log->key = key.key;
      ++log;
      continue;
    }
    state.tokens.set_next_serial(serial);
    memory.count += arrived;
    if (kOneParent) {
      tokens[parent].pairs += arrived;
    }
    arrived = 0;
    sparse.logged = static_cast<std::uint32_t>(log - sparse.log.data());
    if (item != kNil) {
      state.JoinSparsely(index, parent, wme, now, key, item);
    } else {
      state.sparse.MakeRoomToPark(state.tokens, state.links, sparse);
      sparse.log[sparse.logged++] = {parent, wme, now, key.key, kNil};
    }
    serial = state.tokens.next_serial();
    log = sparse.log.data() + sparse.logged;
    end = sparse.log.data() + sparse.log_limit;
  } while (NextPair(state, source, serial, parent, wme));
  state.tokens.set_next_serial(serial);
  memory.count += arrived;
  if (kOneParent) {
    state.tokens[parent].pairs += arrived;
  }
  sparse.logged = static_cast<std::uint32_t>(log - sparse.log.data());
}

template <Differ differ, typename Source>
[[gnu::always_inline]] inline void AddPairs(ReteState& state, std::uint32_t index, Source source) {
  const std::uint32_t join = state.network->node(index).first_child;
  state.joins().LinkOnlyJoin(index, join);
  const RightSide right(state.alphas, state.network->node(join));
  switch (right.kind()) {
    case KeyKind::kId:
      AddPairsOf<differ, KeyKind::kId>(state, index, right, source);
      break;
    case KeyKind::kIdValue:
      AddPairsOf<differ, KeyKind::kIdValue>(state, index, right, source);
      break;
    case KeyKind::kNone:
      break;  // The memory has a key.
  }
}

}  // namespace soarbox::kernel
