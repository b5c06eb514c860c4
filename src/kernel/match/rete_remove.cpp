// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

void ReteState::RemoveWme(std::uint32_t wme) {
  removing = wme;
  links[wme].serial = next_serial++;
  for (std::uint32_t item = links[wme].first_item; item != kNil;) {
    const std::uint32_t next = items[item].next_of_wme;
    RemoveItem(item);
    item = next;
  }
  links[wme].first_item = kNil;
  if (links[wme].unsorted) {
    SortTokensOf(wme);
  }
  // Removal can open negations and so make new tokens, but none with this element: it is in no alpha memory any more.
  while (links[wme].first_token != kNil) {
    const std::uint32_t token = links[wme].first_token;
    const std::uint32_t node = tokens[token].node;
    if (node == Token::kWatchNode) {
      RemoveWatch(token);
    } else if ((node & Token::kResultBit) != 0) {
      RemoveResult(token);
    } else {
      RemoveSubtree(token);
    }
  }
  WmeLinks& link = links[wme];
  if (link.next != kNil) {
    links[link.next].previous = link.previous;
  }
  (link.previous != kNil ? links[link.previous].next : newest_wme) = link.next;
  link.in_match = false;
  --wme_count;
  removing = kNil;
}

void ReteState::RemoveItem(std::uint32_t index) {
  AlphaItem& item = items[index];
  AlphaState& memory = alphas[item.alpha];
  for (std::uint32_t node = memory.sparse == 0 ? kNil : memory.first_node; node != kNil;
       node = nodes[node].next_right) {
    if ((nodes[node].roles & NodeState::kFeedsSparse) != 0) {
      ForgetPairs(node, item.wme);
    }
  }
  if (item.next != kNil) {
    items[item.next].previous = item.previous;
  }
  (item.previous != kNil ? items[item.previous].next : memory.first) = item.next;
  if (memory.id_bits != 0) {
    if (item.next_in_bucket != kNil) {
      items[item.next_in_bucket].previous_in_bucket = item.previous_in_bucket;
    }
    (item.previous_in_bucket != kNil ? items[item.previous_in_bucket].next_in_bucket
                                     : tables[memory.id_table + Hash(item.id, memory.id_bits)]) = item.next_in_bucket;
  }
  if (memory.pair_bits != 0) {
    std::uint32_t* link = &tables[memory.pair_table + Hash(PairKey(item.id, item.value), memory.pair_bits)];
    while (*link != index) {
      link = &items[*link].next_in_pair;
    }
    *link = item.next_in_pair;
  }
  if (--memory.count == 0) {
    for (std::uint32_t node = memory.first_node; node != kNil; node = nodes[node].next_right) {
      if (nodes[node].left_linked) {  // Only joins ever are.
        UnlinkLeft(node);
      }
    }
  }
  item.next = free_items;
  free_items = index;
}

namespace {

[[gnu::always_inline]] inline void UnlinkFromElement(ReteState& state, const Token& token) {
  if (token.wme != kNil) [[likely]] {
    const Records<Token> all = state.tokens.records();
    const std::uint32_t next = token.next_of_wme;
    const std::uint32_t previous = token.previous_of_wme;
    if (next != kNil) {
      all[next].previous_of_wme = previous;
    }
    (previous != kNil ? all[previous].next_of_wme : state.links[token.wme].first_token) = next;
  }
}

inline void UnlinkFromParent(ReteState& state, const Token& token) {
  if (token.parent != kNil) {
    const Records<Token> all = state.tokens.records();
    if (token.next_sibling != kNil) {
      all[token.next_sibling].previous_sibling = token.previous_sibling;
    }
    (token.previous_sibling != kNil ? all[token.previous_sibling].next_sibling : all[token.parent].first_child) =
        token.next_sibling;
  }
}

/// Takes a token off its chain. Counting is the caller's part.
[[gnu::always_inline]] inline void UnlinkFromChain(ReteState& state, NodeState& memory, const Token& token) {
  const Records<Token> all = state.tokens.records();
  const std::uint32_t next = token.next_in_chain;
  const std::uint32_t previous = token.previous_in_chain;
  if (next != kNil) {
    all[next].previous_in_chain = previous;
  }
  if (previous != kNil) {
    all[previous].next_in_chain = next;
  } else {
    (memory.bits == 0 ? memory.head : state.tables[memory.head + ReteState::Hash(token.key, memory.bits)]) = next;
  }
}

[[gnu::always_inline]] inline void Free(ReteState& state, std::uint32_t index) {
  state.tokens[index].made = state.next_serial;
  state.tokens[index].next_sibling = state.free_tokens;
  state.free_tokens = index;
  --state.token_count;
}

}  // namespace

/// Takes a token off the lists of its parent and its element.
void ReteState::UnlinkToken(std::uint32_t index) {
  UnlinkFromParent(*this, tokens[index]);
  UnlinkFromElement(*this, tokens[index]);
}

void ReteState::FreeToken(std::uint32_t index) {
  Free(*this, index);
}

void ReteState::RemoveFromChain(std::uint32_t node, std::uint32_t index) {
  UnlinkFromChain(*this, nodes[node], tokens[index]);
  --nodes[node].count;
}

/// An element that blocked a negative token is going.
void ReteState::RemoveResult(std::uint32_t index) {
  const std::uint32_t owner = tokens[index].parent;
  UnlinkToken(index);
  FreeToken(index);
  if (tokens[owner].first_child == kNil) {
    Emit(tokens[owner].node, owner, kNil);
  }
}

void ReteState::RemoveSubtree(std::uint32_t root) {
  UnlinkFromParent(*this, tokens[root]);
  std::uint32_t token = root;
  for (;;) {
    const Records<Token> all = tokens.records();
    for (std::uint32_t child = all[token].first_child; child != kNil; child = all[token].first_child) {
      if ((all[token].node & (Token::kBlockedBit | Token::kUnsortedBit)) != 0) [[unlikely]] {
        if ((all[token].node & Token::kBlockedBit) != 0) {
          break;
        }
        SortChildren(token);
        continue;
      }
      token = child;
    }
    if (token == root) {
      RemoveLeaf(token);
      return;
    }
    // It is the first of its parent's children.
    const std::uint32_t parent = all[token].parent;
    const std::uint32_t next = all[token].next_sibling;
    all[parent].first_child = next;
    if (next != kNil) {
      all[next].previous_sibling = kNil;
    }
    RemoveLeaf(token);
    token = parent;
  }
}

/// Ends a token that has no children any more and is off its parent's list.
inline void ReteState::RemoveLeaf(std::uint32_t index) {
  const Token& token = tokens[index];
  UnlinkFromElement(*this, token);
  const std::uint32_t node_bits = token.node;
  if ((node_bits & Token::kResultBit) != 0) {
    Free(*this, index);
    return;
  }
  const std::uint32_t node = node_bits & Token::kNodeMask;
  const NodeKind kind = network->node(node).kind;
  if (kind == NodeKind::kMemory || kind == NodeKind::kNegative) [[likely]] {
    NodeState& memory = nodes[node];
    UnlinkFromChain(*this, memory, token);
    if (memory.roles != 0) {
      if ((memory.roles & NodeState::kAboveSparse) != 0 && token.pairs != 0) {
        ForgetPairsOf(node, token.pairs);
      }
      if ((memory.roles & NodeState::kSparse) != 0) {
        --SparseOf(node).tokens;  // Counted as a pair, it goes with its element or its parent.
        Free(*this, index);
        return;
      }
    }
    Free(*this, index);
    if (--memory.count == 0) {
      if (kind == NodeKind::kNegative) {
        if (nodes[node].right_linked) {
          UnlinkRight(node);
        }
        return;
      }
      for (std::uint32_t join = nodes[node].first_linked; join != kNil; join = nodes[join].next_left) {
        if (nodes[join].right_linked) {
          UnlinkRight(join);
        }
      }
    }
    return;
  }
  RemoveRareLeaf(index, kind);
}

void ReteState::RemoveRareLeaf(std::uint32_t index, NodeKind kind) {
  const std::uint32_t node_bits = tokens[index].node;
  const std::uint32_t node = node_bits & Token::kNodeMask;
  switch (kind) {
    case NodeKind::kConjunctive:
      if ((node_bits & Token::kBlockedBit) != 0) {
        for (std::uint32_t result = tokens[index].first_child; result != kNil;) {
          const std::uint32_t next = tokens[result].next_in_chain;
          UnlinkToken(result);
          FreeToken(result);
          result = next;
        }
      }
      RemoveFromChain(node, index);
      FreeToken(index);
      break;
    case NodeKind::kPartner: {
      const std::uint32_t owner = tokens[index].key;
      const std::uint32_t next = tokens[index].next_in_chain;
      const std::uint32_t previous = tokens[index].previous_in_chain;
      if (next != kNil) {
        tokens[next].previous_in_chain = previous;
      }
      (previous != kNil ? tokens[previous].next_in_chain : tokens[owner].first_child) = next;
      FreeToken(index);
      if (tokens[owner].first_child == kNil) {
        tokens[owner].node &= ~Token::kBlockedBit;
        Emit(tokens[owner].node, owner, kNil);
      }
      break;
    }
    case NodeKind::kProduction: {
      RemoveFromChain(node, index);
      const MatchId match = static_cast<MatchId>(tokens[index].key);
      FreeToken(index);
      bool can_return = true;
      if (matches.StateOf(match) == MatchState::kFired) {
        const std::span<const WmeId> all = matches.Wmes(match);
        can_return =
            !excising && (removing == kNil || std::ranges::find(all, static_cast<WmeId>(removing)) == all.end());
      }
      matches.TokenGone(match, can_return, last_timetag);
      break;
    }
    case NodeKind::kMemory:
    case NodeKind::kNegative:
    case NodeKind::kFree:
    case NodeKind::kRoot:
    case NodeKind::kJoin:
      break;
  }
}

// A watched match --------------------------------------------------------------------------------------------------

void ReteState::EndWatch(std::uint32_t first) {
  for (std::uint32_t token = first; token != kNil;) {
    const std::uint32_t next = tokens[token].next_in_chain;
    UnlinkToken(token);
    FreeToken(token);
    token = next;
  }
}

void ReteState::RemoveWatch(std::uint32_t token) {
  const MatchId match = static_cast<MatchId>(tokens[token].key);
  EndWatch(matches.TokenOf(match));
  matches.TokenGone(match, false, last_timetag);
}

// All at once ---------------------------------------------------------------------------------------------------------

void ReteState::Clear() {
  while (newest_wme != kNil) {
    RemoveWme(newest_wme);
  }
  last_timetag = 0;
  matches.Clear();
  // What still matches is made of negations alone.
  for (std::uint32_t production = 0; production < network->rule_limit(); ++production) {
    if (network->rule(production) == nullptr) {
      continue;
    }
    const std::uint32_t node = network->rule(production)->node;
    for (std::uint32_t token = nodes[node].head; token != kNil; token = tokens[token].next_in_chain) {
      MatchSet::Arrival arrival;
      arrival.production = production;
      arrival.token = token;
      tokens[token].key = Index(matches.Assert(arrival));
    }
  }
}

}  // namespace soarbox::kernel
