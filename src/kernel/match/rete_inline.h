// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <utility>

#include "kernel/match/rete_state.h"

/// The innermost loops, shared by the files of the Rete.
namespace soarbox::kernel {

/// Memories up to this size have no table.
inline constexpr std::uint32_t kTinyMemory = 8;

/// The element bound `levels` steps up from a token.
inline std::uint32_t ElementAt(Records<const Token> tokens, std::uint32_t token, std::uint32_t levels) {
  while (levels-- > 0) {
    token = tokens[token].parent;
  }
  return tokens[token].wme;
}

/// The element bound `levels` steps up from the token that stands, or would stand, for (parent, wme).
inline std::uint32_t ElementAt(Records<const Token> tokens, std::uint32_t parent, std::uint32_t wme,
                               std::uint32_t levels) {
  return levels == 0 ? wme : ElementAt(tokens, parent, levels - 1);
}

/// Takes a record for a new token. Everything but its bucket and its key is set.
[[gnu::always_inline]] inline std::uint32_t MakeToken(ReteState& state, std::uint32_t node, std::uint32_t parent,
                                                      std::uint32_t wme, std::uint64_t serial) {
  std::uint32_t index = state.free_tokens;
  if (index != kNil) [[likely]] {
    state.free_tokens = state.tokens[index].next_sibling;
  } else {
    index = state.tokens.Append();
    state.tokens[index].pairs = 0;
    state.tokens[index].forgotten = 0;
  }
  const Records<Token> all = state.tokens.records();
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
    std::uint32_t& head = state.links[wme].first_token;
    other = head;
    head = index;
    if (other != kNil) {
      all[other].previous_of_wme = index;
    }
  }
  token.next_of_wme = other;
  return index;
}

[[gnu::always_inline]] inline std::uint32_t MakeToken(ReteState& state, std::uint32_t node, std::uint32_t parent,
                                                      std::uint32_t wme) {
  return MakeToken(state, node, parent, wme, state.next_serial++);
}

/// What a token of a memory is indexed by.
struct KeyParts {
  std::uint32_t key = 0;    ///< As in Token::key.
  std::uint32_t id = 0;     ///< kId, kIdValue.
  std::uint32_t value = 0;  ///< kIdValue.
};

/// The key of a token of a memory that stands for (parent, wme).
[[gnu::always_inline]] inline KeyParts KeyOfPair(const ReteState& state, const Node& memory, std::uint32_t parent,
                                                 std::uint32_t wme) {
  KeyParts parts;
  if (memory.key == KeyKind::kNone) {
    return parts;
  }
  const Records<const Token> tokens = std::as_const(state.tokens).records();
  const Wme* wmes = state.wmes.data();
  const std::uint32_t with_id = ElementAt(tokens, parent, wme, memory.key_id_levels);
  parts.key = parts.id = ReteState::FieldOf(wmes[with_id], memory.key_id_field);
  if (memory.key == KeyKind::kIdValue) {
    const std::uint32_t with_value = ElementAt(tokens, parent, wme, memory.key_value_levels);
    parts.value = ReteState::FieldOf(wmes[with_value], memory.key_value_field);
    parts.key = ReteState::PairKey(parts.id, parts.value);
  }
  return parts;
}

/// Puts a token at the head of its bucket and lets the table grow with the number of tokens, which is in `counter`.
[[gnu::always_inline]] inline void InsertWithKey(ReteState& state, NodeState& memory, std::uint32_t node,
                                                 std::uint32_t index, std::uint32_t key, bool keyed,
                                                 std::uint32_t& counter) {
  const Records<Token> all = state.tokens.records();
  const std::uint32_t bits = state.marks[node].bits();
  std::uint32_t* head = &memory.head;
  const std::uint32_t count = ++counter;
  bool grow = false;
  if (bits != 0) {
    head = &state.tables[memory.head + ReteState::Hash(key, bits)];
    grow = (count >> bits) != 0;
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
    state.GrowBuckets(node);
  }
}

[[gnu::always_inline]] inline void InsertWithKey(ReteState& state, std::uint32_t node, std::uint32_t index,
                                                 std::uint32_t key, bool keyed) {
  NodeState& memory = state.nodes[node];
  InsertWithKey(state, memory, node, index, key, keyed, memory.count);
}

/// The same for nodes that never have a table.
[[gnu::always_inline]] inline void InsertInList(ReteState& state, NodeState& memory, std::uint32_t index,
                                                std::uint32_t key) {
  const Records<Token> all = state.tokens.records();
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

/// Calls visit(element) for each element that the index of the right side offers for a left token with this key, newest
/// first. Tests are still to be made. Nothing may be added to or removed from the alpha memory meanwhile.
template <typename Visit>
[[gnu::always_inline]] inline void ForEachRight(ReteState& state, const Node& node, const KeyParts& key,
                                                Visit&& visit) {
  const AlphaState& alpha = state.alphas[node.alpha];
  const Records<const AlphaItem> items = std::as_const(state.items).records();
  if (node.key == KeyKind::kId) [[likely]] {
    if (alpha.id_bits == 0) {
      if (alpha.count <= kTinyMemory) {
        for (std::uint32_t item = alpha.first; item != kNil; item = items[item].next) {
          if (items[item].id == key.id) {
            visit(items[item].wme);
          }
        }
        return;
      }
      state.BuildIdTable(node.alpha, 5);
    }
    for (std::uint32_t item = state.tables[alpha.id_table + ReteState::Hash(key.id, alpha.id_bits)]; item != kNil;
         item = items[item].next_in_bucket) {
      if (items[item].id == key.id) {
        visit(items[item].wme);
      }
    }
    return;
  }
  if (node.key == KeyKind::kNone) {
    for (std::uint32_t item = alpha.first; item != kNil; item = items[item].next) {
      visit(items[item].wme);
    }
    return;
  }
  if (alpha.pair_bits == 0) {
    if (alpha.count <= kTinyMemory) {
      for (std::uint32_t item = alpha.first; item != kNil; item = items[item].next) {
        if (items[item].id == key.id && items[item].value == key.value) {
          visit(items[item].wme);
        }
      }
      return;
    }
    state.BuildPairTable(node.alpha, 5);
  }
  for (std::uint32_t item = state.tables[alpha.pair_table + ReteState::Hash(key.key, alpha.pair_bits)]; item != kNil;
       item = items[item].next_in_pair) {
    if (items[item].id == key.id && items[item].value == key.value) {
      visit(items[item].wme);
    }
  }
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

/// Puts an element into an alpha memory.
[[gnu::always_inline]] inline void InsertItem(ReteState& state, std::uint32_t alpha, std::uint32_t wme) {
  std::uint32_t index = state.free_items;
  if (index != kNil) [[likely]] {
    state.free_items = state.items[index].next;
  } else {
    index = state.items.Append();
  }
  const Records<AlphaItem> items = state.items.records();
  AlphaState& memory = state.alphas[alpha];
  AlphaItem& item = items[index];
  item.wme = wme;
  item.alpha = alpha;
  item.id = state.wmes[wme].id.bits();
  item.value = state.wmes[wme].value.bits();
  item.previous = kNil;
  item.next = memory.first;
  if (memory.first != kNil) {
    items[memory.first].previous = index;
  }
  memory.first = index;
  item.next_of_wme = state.links[wme].first_item;
  state.links[wme].first_item = index;
  ++memory.count;

  if (memory.id_bits != 0) {
    if (memory.count > 1u << memory.id_bits) [[unlikely]] {
      state.BuildIdTable(alpha, static_cast<std::uint8_t>(memory.id_bits + 2));
    } else {
      std::uint32_t& head = state.tables[memory.id_table + ReteState::Hash(item.id, memory.id_bits)];
      item.previous_in_bucket = kNil;
      item.next_in_bucket = head;
      if (head != kNil) {
        items[head].previous_in_bucket = index;
      }
      head = index;
    }
  }
  if (memory.pair_bits != 0) {
    if (memory.count > 1u << memory.pair_bits) [[unlikely]] {
      state.BuildPairTable(alpha, static_cast<std::uint8_t>(memory.pair_bits + 2));
    } else {
      const std::uint32_t key = ReteState::PairKey(item.id, item.value);
      std::uint32_t& head = state.tables[memory.pair_table + ReteState::Hash(key, memory.pair_bits)];
      item.next_in_pair = head;
      head = index;
    }
  }
}

/// The key that an element has for a node.
inline std::uint32_t KeyOfElement(const Node& node, const Wme& wme) {
  switch (node.key) {
    case KeyKind::kNone:
      return 0;
    case KeyKind::kId:
      return wme.id.bits();
    case KeyKind::kIdValue:
      return ReteState::PairKey(wme.id.bits(), wme.value.bits());
  }
  return 0;
}

/// Whether a pair has the identifier and value of an element; to be asked of kIdValue keys that are equal.
inline bool HasKey(const ReteState& state, const Node& node, std::uint32_t parent, std::uint32_t left, const Wme& wme) {
  if (node.key != KeyKind::kIdValue) {
    return true;
  }
  const Records<const Token> tokens = std::as_const(state.tokens).records();
  const Wme* wmes = state.wmes.data();
  return wme.id.bits() ==
             ReteState::FieldOf(wmes[ElementAt(tokens, parent, left, node.key_id_levels)], node.key_id_field) &&
         wme.value.bits() ==
             ReteState::FieldOf(wmes[ElementAt(tokens, parent, left, node.key_value_levels)], node.key_value_field);
}
inline bool HasKey(const ReteState& state, const Node& node, std::uint32_t token, const Wme& wme) {
  return HasKey(state, node, state.tokens[token].parent, state.tokens[token].wme, wme);
}

/// The first token of the bucket in which tokens with this key stand (among others).
[[gnu::always_inline]] inline std::uint32_t BucketHead(const ReteState& state, std::uint32_t node, std::uint32_t bits,
                                                       std::uint32_t key) {
  const std::uint32_t head = state.nodes[node].head;
  return bits == 0 ? head : state.tables[head + ReteState::Hash(key, bits)];
}
inline std::uint32_t BucketHead(const ReteState& state, std::uint32_t node, std::uint32_t key) {
  return BucketHead(state, node, state.marks[node].bits(), key);
}

inline std::uint32_t ConjunctiveKey(std::uint32_t parent, std::uint32_t wme) {
  return (parent * 0x85EBCA6Bu) ^ (wme * 0xC2B2AE35u);
}

}  // namespace soarbox::kernel
