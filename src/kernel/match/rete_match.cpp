// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

// Blocking -----------------------------------------------------------------------------------------------------------

void ReteState::Block(std::uint32_t token, std::uint32_t wme) {
  const std::uint32_t child = tokens[token].first_child;
  if (child != kNil && (tokens[child].node & Token::kResultBit) == 0) {
    while (tokens[token].first_child != kNil) {
      RemoveSubtree(tokens[token].first_child);
    }
  }
  MakeToken(*this, tokens[token].node | Token::kResultBit, token, wme);
}

// Left side -----------------------------------------------------------------------------------------------------------

void ReteState::Emit(std::uint32_t node, std::uint32_t token, std::uint32_t wme) {
  for (std::uint32_t child = network->node(node).first_child; child != kNil;
       child = network->node(child).next_sibling) {
    Left(child, token, wme);
  }
}

void ReteState::Left(std::uint32_t node, std::uint32_t token, std::uint32_t wme) {
  switch (network->node(node).kind) {
    case NodeKind::kMemory:
      LeftMemory(node, token, wme);
      break;
    case NodeKind::kProduction:
      LeftProduction(node, token, wme);
      break;
    case NodeKind::kNegative:
      LeftNegative(node, token, wme);
      break;
    case NodeKind::kConjunctive:
      if (network->node(node).IsShared()) {
        LeftShared(node, token, wme);
      } else {
        LeftConjunctive(node, token, wme);
      }
      break;
    case NodeKind::kPartner:
      LeftPartner(node, token, wme);
      break;
    case NodeKind::kPaths:
      LeftPath(node, token, wme);
      break;
    case NodeKind::kGuard:
      LeftGuard(node, token, wme);
      break;
    case NodeKind::kAnchors:  // The conjunctive node creates its tokens.
    case NodeKind::kFree:
    case NodeKind::kRoot:
    case NodeKind::kJoin:
      break;
  }
}

void ReteState::LeftNegative(std::uint32_t node_index, std::uint32_t parent, std::uint32_t wme) {
  const Node& node = network->node(node_index);
  const std::uint32_t token = MakeToken(*this, node_index, parent, wme);
  const KeyParts key = KeyOfPair(*this, node, parent, wme);
  nodes.Insert(tokens, node_index, token, key.key, node.key != KeyKind::kNone);
  if (nodes[node_index].count == 1) {
    joins().LinkRight(node_index);
  }
  bool blocked = false;
  RightSide(alphas, node).ForEach(key, [&](std::uint32_t element) {
    if (PassesAll(*this, *network, node, parent, wme, wmes[element])) {
      MakeToken(*this, node_index | Token::kResultBit, token, element);
      blocked = true;
    }
  });
  if (!blocked) {
    Emit(node_index, token, kNil);
  }
}

void ReteState::LeftConjunctive(std::uint32_t node_index, std::uint32_t parent, std::uint32_t wme) {
  const std::uint32_t key = ConjunctiveKey(parent, wme);
  for (std::uint32_t token = nodes.BucketHead(node_index, key); token != kNil; token = tokens[token].next_in_bucket) {
    if (tokens[token].parent == parent && tokens[token].wme == wme) {
      return;  // Its conjunction matched first and blocks it.
    }
  }
  const std::uint32_t token = MakeToken(*this, node_index, parent, wme);
  nodes.Insert(tokens, node_index, token, key, true);
  Emit(node_index, token, kNil);
}

void ReteState::LeftPartner(std::uint32_t node_index, std::uint32_t parent, std::uint32_t wme) {
  const Node& node = network->node(node_index);
  std::uint32_t top = parent;
  for (std::uint32_t n = 1; n < node.key_id_levels; ++n) {
    top = tokens[top].parent;
  }
  const std::uint32_t owner_parent = tokens[top].parent;
  const std::uint32_t owner_wme = tokens[top].wme;
  const std::uint32_t key = ConjunctiveKey(owner_parent, owner_wme);
  std::uint32_t owner = nodes.BucketHead(node.partner(), key);
  while (owner != kNil && (tokens[owner].parent != owner_parent || tokens[owner].wme != owner_wme)) {
    owner = tokens[owner].next_in_bucket;
  }
  if (owner == kNil) {
    owner = MakeToken(*this, node.partner() | Token::kBlockedBit, owner_parent, owner_wme);
    nodes.Insert(tokens, node.partner(), owner, key, true);
  }
  BlockOwner(owner, parent, wme);
}

/// Makes (parent, wme) a result that blocks the conjunctive token `owner`. Removes the tokens below it.
void ReteState::BlockOwner(std::uint32_t owner, std::uint32_t parent, std::uint32_t wme) {
  if ((tokens[owner].node & Token::kBlockedBit) == 0) {
    while (tokens[owner].first_child != kNil) {
      RemoveSubtree(tokens[owner].first_child);
    }
    tokens[owner].node |= Token::kBlockedBit;
  }
  const std::uint32_t partner = network->node(tokens[owner].node & Token::kNodeMask).partner();
  const std::uint32_t result = MakeToken(*this, partner, parent, wme);
  const std::uint32_t head = tokens[owner].first_child;
  tokens[result].key = owner;
  tokens[result].previous_in_bucket = kNil;
  tokens[result].next_in_bucket = head;
  if (head != kNil) {
    tokens[head].previous_in_bucket = result;
  }
  tokens[owner].first_child = result;
}

/// Creates a match of a rule with the elements in `elements`.
[[gnu::always_inline]] inline void ReteState::NewMatch(std::uint32_t node_index, std::uint32_t parent,
                                                       std::uint32_t wme, std::uint32_t production,
                                                       const RuleInfo& rule) {
  const std::uint32_t token = MakeToken(*this, node_index, parent, wme);
  MatchSet::Arrival arrival;
  arrival.production = production;
  arrival.token = token;
  arrival.elements = {elements.data(), rule.positives};

  MatchId match = MatchId::kNone;
  if (matches.MayReturn(production) && node_index != refraction.node) {
    match = matches.Revive(arrival, wmes);
  }
  if (match != MatchId::kNone) {
    support.Forget(production);
  } else {
    support.LowestGoal(rule, arrival.elements, goals, arrival.goal, arrival.level);
    const NodeState& state = nodes[node_index];
    arrival.o_support = rule.support == RuleInfo::Support::kByMatch
                            ? support.ByMatches(rule, arrival, goals, tokens, state.head, state.count)
                            : rule.support == RuleInfo::Support::kO;
    if (node_index == refraction.node && refraction.match == MatchId::kNone &&
        std::ranges::equal(refraction.elements, arrival.elements)) {
      match = refraction.match = matches.AddFired(arrival, refraction.instantiation);
    } else {
      match = matches.Assert(arrival);
    }
  }
  NodeStates::InsertInList(tokens, nodes[node_index], token, Index(match));
}

void ReteState::LeftProduction(std::uint32_t node_index, std::uint32_t parent, std::uint32_t wme) {
  const std::uint32_t production = network->node(node_index).rule();
  const RuleInfo& rule = *network->rule(production);
  WmeId* const first = elements.data();
  WmeId* place = first + rule.positives;
  if (wme != kNil) {
    *--place = static_cast<WmeId>(wme);
  }
  const Records<const Token> all = tokens.read();
  for (std::uint32_t up = parent; place != first; up = all[up].parent) {
    if (all[up].wme != kNil) {
      *--place = static_cast<WmeId>(all[up].wme);
    }
  }
  NewMatch(node_index, parent, wme, production, rule);
}

/// The negated conditions are satisfied, when the rule is added or later (rete_guard.cpp).
void ReteState::LeftGuard(std::uint32_t node, std::uint32_t parent, std::uint32_t wme) {
  std::uint32_t token = nodes[node].first_linked;
  if (token == kNil) {
    return;  // An element has left.
  }
  const std::uint32_t production = network->node(node).rule();
  const RuleInfo& rule = *network->rule(production);
  WmeId* place = elements.data() + rule.positives;
  for (; token != kNil; token = tokens[token].next_in_bucket) {
    *--place = static_cast<WmeId>(tokens[token].wme);
  }
  NewMatch(node, parent, wme, production, rule);
}

}  // namespace soarbox::kernel
