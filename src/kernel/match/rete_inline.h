// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <utility>

#include "kernel/match/rete_state.h"

/// The innermost loops, shared by the files of the Rete.
namespace soarbox::kernel {

/// Makes a token. Everything but its bucket and its key is set.
[[gnu::always_inline]] inline std::uint32_t MakeToken(ReteState& state, std::uint32_t node, std::uint32_t parent,
                                                      std::uint32_t wme) {
  return state.tokens.Make(state.links, node, parent, wme);
}

/// The key of a token of a memory that stands for (parent, wme).
[[gnu::always_inline]] inline KeyParts KeyOfPair(const ReteState& state, const Node& memory, std::uint32_t parent,
                                                 std::uint32_t wme) {
  KeyParts parts;
  if (memory.key == KeyKind::kNone) {
    return parts;
  }
  const Records<const Token> tokens = state.tokens.read();
  const Wme* wmes = state.wmes.data();
  const std::uint32_t with_id = ElementAt(tokens, parent, wme, memory.key_id_levels);
  parts.key = parts.id = ReteState::FieldOf(wmes[with_id], memory.key_id_field);
  if (memory.key == KeyKind::kIdValue) {
    const std::uint32_t with_value = ElementAt(tokens, parent, wme, memory.key_value_levels);
    parts.value = ReteState::FieldOf(wmes[with_value], memory.key_value_field);
    parts.key = PairKey(parts.id, parts.value);
  }
  return parts;
}

inline bool AreSmallIntegers(std::uint32_t left, std::uint32_t right) {
  constexpr std::uint32_t kSmall = static_cast<std::uint32_t>(Symbol::Tag::kSmallInteger);
  return (left >> Symbol::kIndexBits) == kSmall && (right >> Symbol::kIndexBits) == kSmall;
}

/// One comparison with a constant or a binding. False in `decided` if it is none of the common ones.
[[gnu::always_inline]] inline bool Compare(const ReteState& state, const NodeTest& test, std::uint32_t parent,
                                           std::uint32_t left, const Wme& element, bool& decided) {
  decided = true;
  const std::uint32_t value = ReteState::FieldOf(element, test.field);
  std::uint32_t referent = test.referent;
  if (test.against_binding) {
    referent =
        test.levels == 0
            ? ReteState::FieldOf(element, test.referent_field)
            : ReteState::FieldOf(state.wmes.data()[ElementAt(state.tokens.records(), parent, left, test.levels - 1u)],
                                 test.referent_field);
  }
  if (test.op <= TestOp::kNotEqual) {
    return (value == referent) == (test.op == TestOp::kEqual);
  }
  if (test.op <= TestOp::kGreaterOrEqual && AreSmallIntegers(value, referent)) {
    const auto a = static_cast<std::int32_t>(value << 3);
    const auto b = static_cast<std::int32_t>(referent << 3);
    // kLess, kGreater, kLessOrEqual, kGreaterOrEqual, in this order.
    const bool upwards = test.op == TestOp::kLess || test.op == TestOp::kLessOrEqual;
    const bool strict = test.op <= TestOp::kGreater;
    return upwards ? (a < b || (!strict && a == b)) : (a > b || (!strict && a == b));
  }
  decided = false;
  return false;
}

/// Whether (parent, left) and an element pass a join's tests, with the commonest case (one comparison) at hand.
[[gnu::always_inline]] inline bool PassesAll(const ReteState& state, const Network& network, const Node& node,
                                             std::uint32_t parent, std::uint32_t left, const Wme& element) {
  const NodeTest* test = network.tests(node).data();
  for (const NodeTest* const end = test + node.test_count; test != end; ++test) {
    bool decided;
    if (!Compare(state, *test, parent, left, element, decided)) {
      return !decided && state.Passes(node, parent, left, element);
    }
  }
  return true;
}

/// The key that an element has for a node.
inline std::uint32_t KeyOfElement(const Node& node, const Wme& wme) {
  switch (node.key) {
    case KeyKind::kNone:
      return 0;
    case KeyKind::kId:
      return wme.id.bits();
    case KeyKind::kIdValue:
      return PairKey(wme.id.bits(), wme.value.bits());
  }
  return 0;
}

/// Whether a pair has the identifier and value of an element; to be asked of kIdValue keys that are equal.
inline bool HasKey(const ReteState& state, const Node& node, std::uint32_t parent, std::uint32_t left, const Wme& wme) {
  if (node.key != KeyKind::kIdValue) {
    return true;
  }
  const Records<const Token> tokens = state.tokens.read();
  const Wme* wmes = state.wmes.data();
  return wme.id.bits() ==
             ReteState::FieldOf(wmes[ElementAt(tokens, parent, left, node.key_id_levels)], node.key_id_field) &&
         wme.value.bits() ==
             ReteState::FieldOf(wmes[ElementAt(tokens, parent, left, node.key_value_levels)], node.key_value_field);
}
inline bool HasKey(const ReteState& state, const Node& node, std::uint32_t token, const Wme& wme) {
  return HasKey(state, node, state.tokens[token].parent, state.tokens[token].wme, wme);
}

/// Calls visit(element) for the pairs of a run, parked in a sparse memory, that are still there, newest element first,
/// until it returns true.
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

inline std::uint32_t ConjunctiveKey(std::uint32_t parent, std::uint32_t wme) {
  return (parent * 0x85EBCA6Bu) ^ (wme * 0xC2B2AE35u);
}

}  // namespace soarbox::kernel
