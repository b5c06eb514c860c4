// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <utility>

#include "kernel/match/rete_state.h"

/// The innermost loops, which several files of the Rete use.
namespace soarbox::kernel {

/// Creates a token. Sets everything except its bucket and its key.
[[gnu::always_inline]] inline std::uint32_t MakeToken(ReteState& state, std::uint32_t node, std::uint32_t parent,
                                                      std::uint32_t wme) {
  return state.tokens.Make(state.links, node, parent, wme);
}

/// The key of a memory's token for (parent, wme).
[[gnu::always_inline]] inline KeyParts KeyOfPair(const ReteState& state, const Node& memory, std::uint32_t parent,
                                                 std::uint32_t wme) {
  KeyParts parts;
  if (memory.key == KeyKind::kNone) {
    return parts;
  }
  const Records<const Token> tokens = state.tokens.read();
  const Wme* wmes = state.wmes.data();
  const std::uint32_t with_id = ElementAt(tokens, parent, wme, memory.key_id_levels);
  parts.key = parts.id = BitsOf(wmes[with_id], memory.key_id_field);
  if (memory.key == KeyKind::kIdValue) {
    const std::uint32_t with_value = ElementAt(tokens, parent, wme, memory.key_value_levels);
    parts.value = BitsOf(wmes[with_value], memory.key_value_field);
    parts.key = PairKey(parts.id, parts.value);
  }
  return parts;
}

/// Whether (parent, left) and an element pass a join's tests, with a short path for the most common case (one
/// comparison).
[[gnu::always_inline]] inline bool PassesAll(const ReteState& state, const Network& network, const Node& node,
                                             std::uint32_t parent, std::uint32_t left, const Wme& element) {
  const NodeTest* test = network.tests(node).data();
  for (const NodeTest* const end = test + node.test_count; test != end; ++test) {
    bool decided;
    if (!Compare(state.tokens, state.wmes, *test, parent, left, element, decided)) {
      return !decided && state.pair_tests.Passes(node, parent, left, element);
    }
  }
  return true;
}

/// Calls visit(element) for the existing pairs of a run that is parked in a sparse memory, newest element first. Stops
/// when it returns true.
template <typename Visit>
void ForEachOfRun(const ReteState& state, std::uint32_t memory, const ParkedRun& run, Visit&& visit) {
  const AlphaState& alpha = state.alphas[state.network->node(state.network->node(memory).parent).alpha];
  const std::uint32_t id = state.tokens[run.parent].key;
  const Records<const AlphaItem> all = state.alphas.items();
  for (std::uint32_t index = state.alphas.IdBucket(alpha, id); index != kNil; index = all[index].next_in_bucket) {
    const AlphaItem& item = all[index];
    const std::uint64_t arrival = state.links[item.wme].serial;
    if (item.id == id && arrival <= run.newest) {
      if (arrival < run.oldest || visit(item.wme)) {
        return;
      }
    }
  }
}

/// The child of the root from which a node descends; outside of conjunctions.
inline std::uint32_t BelowRoot(const Network& network, std::uint32_t node) {
  while (network.node(node).parent != 0) {
    node = network.node(node).parent;
  }
  return node;
}

inline std::uint32_t ConjunctiveKey(std::uint32_t parent, std::uint32_t wme) {
  return (parent * 0x85EBCA6Bu) ^ (wme * 0xC2B2AE35u);
}

}  // namespace soarbox::kernel
