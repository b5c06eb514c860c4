// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/match/rete_state.h"

/// The innermost loops, shared by the files of the Rete.
namespace soarbox::kernel {

/// Memories up to this size have no table.
inline constexpr std::uint32_t kTinyMemory = 8;

/// The element bound `levels` steps up from a token.
inline std::uint32_t ElementAt(const Token* tokens, std::uint32_t token, std::uint32_t levels) {
  while (levels-- > 0) {
    token = tokens[token].parent;
  }
  return tokens[token].wme;
}

/// Calls visit(element) for each element that the index of the right side offers for a left token, newest first. Tests
/// are still to be made. Nothing may be added to or removed from the alpha memory meanwhile.
template <typename Visit>
inline void ForEachRight(ReteState& state, const Node& node, std::uint32_t left, Visit&& visit) {
  const AlphaState& alpha = state.alphas[node.alpha];
  if (node.key == KeyKind::kNone) {
    for (std::uint32_t item = alpha.first; item != kNil;) {
      const AlphaItem& i = state.items[item];
      item = i.next;
      visit(i.wme);
    }
    return;
  }
  if (node.key == KeyKind::kId) {
    const std::uint32_t id = state.tokens[left].key;
    if (alpha.id_bits == 0) {
      if (alpha.count <= kTinyMemory) {
        for (std::uint32_t item = alpha.first; item != kNil;) {
          const AlphaItem& i = state.items[item];
          item = i.next;
          if (i.id == id) {
            visit(i.wme);
          }
        }
        return;
      }
      state.BuildIdTable(node.alpha, 5);
    }
    std::uint32_t item = state.tables[alpha.id_table + ReteState::Hash(id, alpha.id_bits)];
    while (item != kNil) {
      const AlphaItem& i = state.items[item];
      item = i.next_in_bucket;
      if (i.id == id) {
        visit(i.wme);
      }
    }
    return;
  }
  const Token* tokens = state.tokens.data();
  const std::uint32_t id =
      ReteState::FieldOf(state.wmes[ElementAt(tokens, left, node.key_id_levels)], node.key_id_field);
  const std::uint32_t value =
      ReteState::FieldOf(state.wmes[ElementAt(tokens, left, node.key_value_levels)], node.key_value_field);
  if (alpha.pair_bits == 0) {
    if (alpha.count <= kTinyMemory) {
      for (std::uint32_t item = alpha.first; item != kNil;) {
        const AlphaItem& i = state.items[item];
        item = i.next;
        if (i.id == id && i.value == value) {
          visit(i.wme);
        }
      }
      return;
    }
    state.BuildPairTable(node.alpha, 5);
  }
  std::uint32_t item = state.tables[alpha.pair_table + ReteState::Hash(ReteState::PairKey(id, value), alpha.pair_bits)];
  while (item != kNil) {
    const AlphaItem& i = state.items[item];
    item = i.next_in_pair;
    if (i.id == id && i.value == value) {
      visit(i.wme);
    }
  }
}

/// The key that an element has for a node.
inline std::uint32_t KeyOfElement(const Node& node, const Wme& wme) {
  switch (node.key) {
    case KeyKind::kNone: return 0;
    case KeyKind::kId: return wme.id.bits();
    case KeyKind::kIdValue: return ReteState::PairKey(wme.id.bits(), wme.value.bits());
  }
  return 0;
}

/// Whether a token has the identifier and value that a kIdValue key asks for.
inline bool HasKey(const ReteState& state, const Node& node, std::uint32_t token, const Wme& wme) {
  const Token* tokens = state.tokens.data();
  return wme.id.bits() == ReteState::FieldOf(state.wmes[ElementAt(tokens, token, node.key_id_levels)],
                                             node.key_id_field) &&
         wme.value.bits() == ReteState::FieldOf(state.wmes[ElementAt(tokens, token, node.key_value_levels)],
                                                node.key_value_field);
}

/// The first token of the chain in which tokens with this key stand (among others).
inline std::uint32_t ChainHead(const ReteState& state, const NodeState& memory, std::uint32_t key) {
  return memory.bits == 0 ? memory.head : state.tables[memory.head + ReteState::Hash(key, memory.bits)];
}

inline std::uint32_t ConjunctiveKey(std::uint32_t parent, std::uint32_t wme) {
  return (parent * 0x85EBCA6Bu) ^ (wme * 0xC2B2AE35u);
}

}  // namespace soarbox::kernel
