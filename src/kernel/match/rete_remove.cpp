// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

[[gnu::always_inline]] inline void ReteState::RemoveItem(std::uint32_t index) {
  const Records<AlphaItem> all = items.records();
  AlphaItem& item = all[index];
  AlphaState& memory = alphas[item.alpha];
  if ((memory.sparse & AlphaState::kInPaths) != 0) {
    path_element = true;
  }
  if ((memory.sparse & ~AlphaState::kFlags) != 0) {
    for (std::uint32_t node = memory.first_node; node != kNil; node = nodes[node].next_right) {
      if (marks[node].Is(NodeMarks::kFeedsSparse)) {
        ForgetPairs(node, item.wme);
      }
    }
  }
  const std::uint32_t next = item.next;
  const std::uint32_t previous = item.previous;
  if (next != kNil) {
    all[next].previous = previous;
  }
  (previous != kNil ? all[previous].next : memory.first) = next;
  if (memory.id_bits != 0) {
    const std::uint32_t next_in_bucket = item.next_in_bucket;
    if (next_in_bucket != kNil) {
      all[next_in_bucket].previous_in_bucket = item.previous_in_bucket;
    }
    (item.previous_in_bucket != kNil ? all[item.previous_in_bucket].next_in_bucket
                                     : tables[memory.id_table + Hash(item.id, memory.id_bits)]) = next_in_bucket;
  }
  if (memory.pair_bits != 0) {
    std::uint32_t* link = &tables[memory.pair_table + Hash(PairKey(item.id, item.value), memory.pair_bits)];
    while (*link != index) {
      link = &all[*link].next_in_pair;
    }
    *link = item.next_in_pair;
  }
  if (--memory.count == 0) {
    for (std::uint32_t node = memory.first_node; node != kNil; node = nodes[node].next_right) {
      if (marks[node].Is(NodeMarks::kLeftLinked)) {  // Only joins ever are.
        UnlinkLeft(node);
      }
    }
  }
  item.next = free_items;
  free_items = index;
}

void ReteState::RemoveTokenOfElement(std::uint32_t token) {
  const std::uint32_t node = tokens[token].node;
  if (node == Token::kFixedMatchNode) {
    RetractFixedMatch(token);
  } else if ((node & Token::kResultBit) != 0) {
    RemoveResult(token);
  } else {
    RemoveSubtree(token);
  }
}

void ReteState::RemoveWme(std::uint32_t wme) {
  removing = wme;
  WmeLinks& link = links[wme];
  arrival_of_removing = link.serial;
  link.serial = next_serial++;
  for (std::uint32_t item = link.first_item; item != kNil;) {
    const std::uint32_t next = items[item].next_of_wme;
    RemoveItem(item);
    item = next;
  }
  link.first_item = kNil;
  if (link.unsorted) {
    SortTokensOf(wme);
  }
  if (path_element) [[unlikely]] {
    RemoveTokensInOrder(wme);
  }
  // Removal can open negations and so make new tokens, but none with this element: it is in no alpha memory any more.
  for (std::uint32_t token = link.first_token; token != kNil; token = link.first_token) {
    RemoveTokenOfElement(token);
  }
  if (link.next != kNil) {
    links[link.next].previous = link.previous;
  }
  (link.previous != kNil ? links[link.previous].next : newest_wme) = link.next;
  link.in_match = false;
  --wme_count;
  removing = kNil;
}

namespace {

[[gnu::always_inline]] inline void UnlinkFromElement(ReteState& state, Records<Token> all, const Token& token) {
  if (token.wme != kNil) [[likely]] {
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

/// Takes a token off its bucket. Counting is the caller's part.
[[gnu::always_inline]] inline void UnlinkFromBucket(ReteState& state, Records<Token> all, std::uint32_t node,
                                                    const Token& token) {
  const std::uint32_t next = token.next_in_bucket;
  const std::uint32_t previous = token.previous_in_bucket;
  if (next != kNil) {
    all[next].previous_in_bucket = previous;
  }
  if (previous != kNil) {
    all[previous].next_in_bucket = next;
  } else {
    std::uint32_t& head = state.nodes[node].head;
    const std::uint32_t bits = state.marks[node].bits();
    (bits == 0 ? head : state.tables[head + ReteState::Hash(token.key, bits)]) = next;
  }
}

[[gnu::always_inline]] inline void Free(ReteState& state, std::uint32_t index) {
  state.tokens[index].next_sibling = state.free_tokens;
  state.free_tokens = index;
}

}  // namespace

/// Takes a token off the lists of its parent and its element.
void ReteState::UnlinkToken(std::uint32_t index) {
  UnlinkFromParent(*this, tokens[index]);
  UnlinkFromElement(*this, tokens.records(), tokens[index]);
}

void ReteState::FreeToken(std::uint32_t index) {
  Free(*this, index);
}

/// Frees all results of a blocked conjunctive token.
void ReteState::FreeResults(std::uint32_t owner) {
  for (std::uint32_t result = tokens[owner].first_child; result != kNil;) {
    const std::uint32_t next = tokens[result].next_in_bucket;
    UnlinkToken(result);
    FreeToken(result);
    result = next;
  }
  tokens[owner].first_child = kNil;
}

void ReteState::RemoveFromBucket(std::uint32_t node, std::uint32_t index) {
  UnlinkFromBucket(*this, tokens.records(), node, tokens[index]);
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

// From leaf to leaf: a parent comes after its last child.
void ReteState::RemoveSubtree(std::uint32_t root) {
  UnlinkFromParent(*this, tokens[root]);
  Records<Token> all = tokens.records();
  std::uint32_t token = root;
  for (;;) {
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
    Token& leaf = all[token];
    const std::uint32_t parent = leaf.parent;
    const std::uint32_t next = leaf.next_sibling;
    if (token != root) {  // It is the first of its parent's children.
      all[parent].first_child = next;
      if (next != kNil) {
        all[next].previous_sibling = kNil;
      }
    }
    UnlinkFromElement(*this, all, leaf);
    if ((leaf.node & Token::kResultBit) == 0) {
      const std::uint32_t node = leaf.node & Token::kNodeMask;
      if (!marks[node].Is(NodeMarks::kUncommonEnd)) {
        UnlinkFromBucket(*this, all, node, leaf);
        if (--nodes[node].count == 0) {
          MemoryEmptied(node);
        }
      } else if (marks[node].Is(NodeMarks::kOther)) {
        RemoveRareLeaf(token);
        if (token == root) {
          return;
        }
        all = tokens.records();
        token = parent;
        continue;
      } else {
        UnlinkFromBucket(*this, all, node, leaf);
        if (marks[node].Is(NodeMarks::kAboveSparse)) {
          if (leaf.pairs != 0) {
            ForgetPairsOf(SparseBelow(node), leaf.pairs);
            leaf.pairs = 0;
          }
          leaf.forgotten = next_serial;
        }
        if (marks[node].Is(NodeMarks::kSparse)) {
          --SparseOf(node).tokens;  // Counted as a pair, it goes with its element or its parent.
        } else if (--nodes[node].count == 0) {
          MemoryEmptied(node);
        }
      }
    }
    leaf.next_sibling = free_tokens;
    free_tokens = token;
    if (token == root) {
      return;
    }
    token = next != kNil ? next : parent;
  }
}

/// The last token of a memory or a negative node is going: nothing can join with it from the right.
void ReteState::MemoryEmptied(std::uint32_t node) {
  if (marks[node].Is(NodeMarks::kNegative)) {
    if (marks[node].Is(NodeMarks::kRightLinked)) {
      UnlinkRight(node);
    }
    return;
  }
  for (std::uint32_t join = nodes[node].first_linked; join != kNil; join = nodes[join].next_left) {
    if (marks[join].Is(NodeMarks::kRightLinked)) {
      UnlinkRight(join);
    }
  }
}

void ReteState::RemoveRareLeaf(std::uint32_t index) {
  const std::uint32_t node_bits = tokens[index].node;
  const std::uint32_t node = node_bits & Token::kNodeMask;
  switch (network->node(node).kind) {
    case NodeKind::kConjunctive:
      if ((node_bits & Token::kBlockedBit) != 0) {
        FreeResults(index);
      }
      RemoveFromBucket(node, index);
      FreeToken(index);
      if (network->node(node).IsShared()) {
        const std::uint32_t anchor = std::exchange(tokens[index].pairs, 0);
        tokens[index].node = 0;  // Nobody takes it for an owner any more.
        last_owner = last_owner == index ? kNil : last_owner;
        OwnerGone(anchor);
      }
      break;
    case NodeKind::kPartner: {
      const std::uint32_t owner = tokens[index].key;
      const std::uint32_t next = tokens[index].next_in_bucket;
      const std::uint32_t previous = tokens[index].previous_in_bucket;
      if (next != kNil) {
        tokens[next].previous_in_bucket = previous;
      }
      (previous != kNil ? tokens[previous].next_in_bucket : tokens[owner].first_child) = next;
      FreeToken(index);
      if (tokens[owner].first_child == kNil) {
        tokens[owner].node &= ~Token::kBlockedBit;
        Emit(tokens[owner].node, owner, kNil);
      }
      break;
    }
    case NodeKind::kProduction:
    case NodeKind::kGuard: {
      RemoveFromBucket(node, index);
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
    case NodeKind::kAnchors:
    case NodeKind::kPaths:
    case NodeKind::kFree:
    case NodeKind::kRoot:
    case NodeKind::kJoin:
      break;
  }
}

// Fixed matches -------------------------------------------------------------------------------------------------------

void ReteState::FreeFixedMatch(std::uint32_t first) {
  for (std::uint32_t token = first; token != kNil;) {
    const std::uint32_t next = tokens[token].next_in_bucket;
    UnlinkToken(token);
    FreeToken(token);
    token = next;
  }
}

void ReteState::RetractFixedMatch(std::uint32_t token) {
  if (tokens[token].previous_in_bucket == Token::kGuarded) {
    GuardedElementGone(tokens[token].key);
    return;
  }
  const MatchId match = static_cast<MatchId>(tokens[token].key);
  FreeFixedMatch(matches.TokenOf(match));
  matches.TokenGone(match, false, last_timetag);
}

// All at once ---------------------------------------------------------------------------------------------------------

/// What tokens and items point to may be half made: nothing is followed, and nothing is allocated.
void ReteState::Abandon() {
  abandoned = true;
  tokens.Release();
  parked.Release();
  items.Release();
  free_tokens = free_parked = free_items = newest_wme = kNil;
  wme_count = 0;
  sparse.clear();
  tables = TablePool();
  links = std::vector<WmeLinks>();
  std::fill(nodes.begin(), nodes.end(), NodeState());
  std::fill(marks.begin(), marks.end(), NodeMarks());
  std::fill(alphas.begin(), alphas.end(), AlphaState());
}

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
    for (std::uint32_t token = nodes[node].head; token != kNil; token = tokens[token].next_in_bucket) {
      MatchSet::Arrival arrival;
      arrival.production = production;
      arrival.token = token;
      tokens[token].key = Index(matches.Assert(arrival));
    }
  }
}

}  // namespace soarbox::kernel
