// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "kernel/match/fixed_match.h"
#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

[[gnu::always_inline]] inline void ReteState::RemoveItem(std::uint32_t index) {
  const AlphaItem& item = alphas.item(index);
  AlphaState& memory = alphas[item.alpha];
  if ((memory.sparse & AlphaState::kInPaths) != 0) {
    shared.path_element = true;
  }
  if ((memory.sparse & ~AlphaState::kFlags) != 0) {
    for (const std::uint32_t join : feeders.Of(item.alpha)) {
      ForgetPairs(join, item.wme);
    }
  }
  alphas.TakeOut(memory, index);
  if (--memory.count == 0) {
    for (std::uint32_t node = memory.first_node; node != kNil; node = nodes[node].next_right) {
      if (nodes.marks(node).Is(NodeMarks::kLeftLinked)) {  // Only joins are ever left-linked.
        joins().UnlinkLeft(node);
      }
    }
  }
  alphas.Free(index);
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
  links.BeginLeaving(wme, tokens.TakeSerial());
  WmeLinks& link = links[wme];
  for (std::uint32_t item = link.first_item; item != kNil;) {
    const std::uint32_t next = alphas.item(item).next_of_wme;
    RemoveItem(item);
    item = next;
  }
  link.first_item = kNil;
  if (link.unsorted) {
    tokens.SortTokensOf(link);
  }
  if (shared.path_element) [[unlikely]] {
    RemoveTokensInOrder(wme);
  }
  // Removal can open negations and thus create tokens, but none with this element: it is in no alpha memory any more.
  for (std::uint32_t token = link.first_token; token != kNil; token = link.first_token) {
    RemoveTokenOfElement(token);
  }
  links.Leave(link);
}

/// An element that blocked a negative token is leaving.
void ReteState::RemoveResult(std::uint32_t index) {
  const std::uint32_t owner = tokens[index].parent;
  tokens.Unlink(links, index);
  tokens.Free(index);
  if (tokens[owner].first_child == kNil) {
    Emit(tokens[owner].node, owner, kNil);
  }
}

// Iterates from leaf to leaf: a parent follows its last child.
void ReteState::RemoveSubtree(std::uint32_t root) {
  tokens.UnlinkFromParent(tokens[root]);
  Records<Token> all = tokens.records();
  std::uint32_t token = root;
  for (;;) {
    for (std::uint32_t child = all[token].first_child; child != kNil; child = all[token].first_child) {
      if ((all[token].node & (Token::kBlockedBit | Token::kUnsortedBit)) != 0) [[unlikely]] {
        if ((all[token].node & Token::kBlockedBit) != 0) {
          break;
        }
        tokens.SortChildren(token);
        continue;
      }
      token = child;
    }
    Token& leaf = all[token];
    const std::uint32_t parent = leaf.parent;
    const std::uint32_t next = leaf.next_sibling;
    if (token != root) {  // It is the first child of its parent.
      all[parent].first_child = next;
      if (next != kNil) {
        all[next].previous_sibling = kNil;
      }
    }
    TokenPool::UnlinkFromElement(links, all, leaf);
    if ((leaf.node & Token::kResultBit) == 0) {
      const std::uint32_t node = leaf.node & Token::kNodeMask;
      if (!nodes.marks(node).Is(NodeMarks::kUncommonEnd)) {
        nodes.UnlinkFromBucket(all, node, leaf);
        if (--nodes[node].count == 0) {
          joins().MemoryEmptied(node);
        }
      } else if (nodes.marks(node).Is(NodeMarks::kOther)) {
        RemoveRareLeaf(token);
        if (token == root) {
          return;
        }
        all = tokens.records();
        token = parent;
        continue;
      } else {
        nodes.UnlinkFromBucket(all, node, leaf);
        if (nodes.marks(node).Is(NodeMarks::kAboveSparse)) {
          if (leaf.pairs != 0) {
            ForgetPairsOf(network->MemoryBelow(node), leaf.pairs);
            leaf.pairs = 0;
          }
          tokens.ForgetPairs(leaf);
        }
        if (nodes.marks(node).Is(NodeMarks::kSparse)) {
          --SparseOf(node).tokens;  // As a pair, it is subtracted when its element or its parent leaves.
        } else if (--nodes[node].count == 0) {
          joins().MemoryEmptied(node);
        }
      }
    }
    tokens.Free(leaf, token);
    if (token == root) {
      return;
    }
    token = next != kNil ? next : parent;
  }
}

void ReteState::RemoveRareLeaf(std::uint32_t index) {
  const std::uint32_t node_bits = tokens[index].node;
  const std::uint32_t node = node_bits & Token::kNodeMask;
  switch (network->node(node).kind) {
    case NodeKind::kConjunctive:
      if ((node_bits & Token::kBlockedBit) != 0) {
        tokens.FreeResults(links, index);
      }
      nodes.RemoveFromBucket(tokens, node, index);
      tokens.Free(index);
      if (network->node(node).IsShared()) {
        const std::uint32_t anchor = std::exchange(tokens[index].pairs, 0);
        tokens[index].node = 0;  // So that it no longer counts as an owner.
        shared.last_owner = shared.last_owner == index ? kNil : shared.last_owner;
        if (--tokens[anchor].previous_sibling == 0) {  // It was the last of its owners.
          tokens[anchor].previous_sibling = kNil;
          RemoveSubtree(anchor);
        }
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
      tokens.Free(index);
      if (tokens[owner].first_child == kNil) {
        tokens[owner].node &= ~Token::kBlockedBit;
        Emit(tokens[owner].node, owner, kNil);
      }
      break;
    }
    case NodeKind::kProduction:
    case NodeKind::kGuard: {
      nodes.RemoveFromBucket(tokens, node, index);
      const MatchId match = static_cast<MatchId>(tokens[index].key);
      tokens.Free(index);
      bool can_return = true;
      if (matches.StateOf(match) == MatchState::kFired) {
        const std::span<const WmeId> all = matches.Wmes(match);
        can_return = !excising && (links.leaving() == kNil ||
                                   std::ranges::find(all, static_cast<WmeId>(links.leaving())) == all.end());
      }
      matches.TokenGone(match, can_return, links.last_timetag());
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

void ReteState::RetractFixedMatch(std::uint32_t token) {
  if (tokens[token].previous_in_bucket == Token::kGuarded) {
    GuardedElementGone(tokens[token].key);
    return;
  }
  const MatchId match = static_cast<MatchId>(tokens[token].key);
  FreeElementTokens(tokens, links, matches.TokenOf(match));
  matches.TokenGone(match, false, links.last_timetag());
}

// Releasing everything ------------------------------------------------------------------------------------------------

/// The structures of tokens and items may be inconsistent: follows no references and allocates nothing.
void ReteState::Abandon() {
  abandoned = true;
  tokens.Release();
  sparse.Release();
  alphas.Release();
  links.Release();
  nodes.Release();
}

void ReteState::Clear() {
  while (links.newest() != kNil) {
    RemoveWme(links.newest());
  }
  links.ForgetTimetags();
  matches.Clear();
  // Only matches of rules without positive conditions remain.
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
