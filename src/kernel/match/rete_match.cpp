// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/base/symbol_table.h"
#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

namespace {

std::strong_ordering CompareSymbols(const SymbolTable& symbols, std::uint32_t left, std::uint32_t right) {
  if (AreSmallIntegers(left, right)) {
    return static_cast<std::int32_t>(left << 3) <=> static_cast<std::int32_t>(right << 3);
  }
  return symbols.Compare(Symbol::FromBits(left), Symbol::FromBits(right));
}

}  // namespace

// Tests ---------------------------------------------------------------------------------------------------------------

/// One test that Compare does not decide.
bool ReteState::PassesTest(const NodeTest& test, std::uint32_t parent, std::uint32_t left, const Wme& wme) const {
  const std::uint32_t value = FieldOf(wme, test.field);
  std::uint32_t referent = test.referent;
  if (test.against_binding) {
    referent = test.levels == 0 ? FieldOf(wme, test.referent_field)
                                : FieldOf(wmes.data()[ElementAt(tokens.records(), parent, left, test.levels - 1u)],
                                          test.referent_field);
  }
  bool passed = false;
  switch (test.op) {
    case TestOp::kEqual:
    case TestOp::kNotEqual:
      break;  // Decided above.
    case TestOp::kLess:
      passed = CompareSymbols(symbols, value, referent) < 0;
      break;
    case TestOp::kGreater:
      passed = CompareSymbols(symbols, value, referent) > 0;
      break;
    case TestOp::kLessOrEqual:
      passed = CompareSymbols(symbols, value, referent) <= 0;
      break;
    case TestOp::kGreaterOrEqual:
      passed = CompareSymbols(symbols, value, referent) >= 0;
      break;
    case TestOp::kSameType:
      passed = Symbol::FromBits(value).kind() == Symbol::FromBits(referent).kind();
      break;
    case TestOp::kDisjunction: {
      const std::uint32_t* first = network->disjuncts(test);
      passed = std::find(first, first + test.count, value) != first + test.count;
      break;
    }
    case TestOp::kIsGoal:
      passed = goals.LevelOf(Symbol::FromBits(value)) != 0;
      break;
    case TestOp::kNever:
      passed = false;
      break;
    case TestOp::kSameLti:
    case TestOp::kNotSameLti: {
      const Symbol other = Symbol::FromBits(referent);
      const std::uint64_t lti = goals.LtiOf(Symbol::FromBits(value));
      const std::uint64_t wanted =
          other.IsInteger() ? static_cast<std::uint64_t>(symbols.IntegerValue(other)) : goals.LtiOf(other);
      passed = (lti != 0 && lti == wanted) == (test.op == TestOp::kSameLti);
      break;
    }
    case TestOp::kIsLti:
      passed = goals.LtiOf(Symbol::FromBits(value)) != 0;
      break;
    case TestOp::kIsNotLti:
      passed = goals.LtiOf(Symbol::FromBits(value)) == 0;
      break;
  }
  return passed;
}

bool ReteState::PassesOne(const NodeTest& test, std::uint32_t parent, std::uint32_t left, const Wme& wme) const {
  bool decided;
  return Compare(*this, test, parent, left, wme, decided) || (!decided && PassesTest(test, parent, left, wme));
}

bool ReteState::Passes(const Node& node, std::uint32_t parent, std::uint32_t left, const Wme& wme) const {
  return std::ranges::all_of(network->tests(node),
                             [&](const NodeTest& test) { return PassesOne(test, parent, left, wme); });
}

// Tokens --------------------------------------------------------------------------------------------------------------

std::uint32_t ReteState::NewToken(std::uint32_t node, std::uint32_t parent, std::uint32_t wme) {
  return MakeToken(*this, node, parent, wme);
}

std::uint32_t ReteState::KeyOfToken(const Node& memory, std::uint32_t token) const {
  return KeyOfPair(*this, memory, tokens[token].parent, tokens[token].wme).key;
}

// Blocking -----------------------------------------------------------------------------------------------------------

void ReteState::Block(std::uint32_t token, std::uint32_t wme) {
  const std::uint32_t child = tokens[token].first_child;
  if (child != kNil && (tokens[child].node & Token::kResultBit) == 0) {
    while (tokens[token].first_child != kNil) {
      RemoveSubtree(tokens[token].first_child);
    }
  }
  NewToken(tokens[token].node | Token::kResultBit, token, wme);
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
    case NodeKind::kAnchors:  // Its tokens come from the conjunctive node.
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
    LinkRight(node_index);
  }
  bool blocked = false;
  RightSide(alphas, node).ForEach(key, [&](std::uint32_t element) {
    if (PassesAll(*this, *network, node, parent, wme, wmes[element])) {
      NewToken(node_index | Token::kResultBit, token, element);
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
  const std::uint32_t token = NewToken(node_index, parent, wme);
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
    owner = NewToken(node.partner() | Token::kBlockedBit, owner_parent, owner_wme);
    nodes.Insert(tokens, node.partner(), owner, key, true);
  }
  BlockOwner(owner, parent, wme);
}

/// Makes (parent, wme) a result for a conjunctive token, which is blocked from then on: what it has led to goes.
void ReteState::BlockOwner(std::uint32_t owner, std::uint32_t parent, std::uint32_t wme) {
  if ((tokens[owner].node & Token::kBlockedBit) == 0) {
    while (tokens[owner].first_child != kNil) {
      RemoveSubtree(tokens[owner].first_child);
    }
    tokens[owner].node |= Token::kBlockedBit;
  }
  const std::uint32_t partner = network->node(tokens[owner].node & Token::kNodeMask).partner();
  const std::uint32_t result = NewToken(partner, parent, wme);
  const std::uint32_t head = tokens[owner].first_child;
  tokens[result].key = owner;
  tokens[result].previous_in_bucket = kNil;
  tokens[result].next_in_bucket = head;
  if (head != kNil) {
    tokens[head].previous_in_bucket = result;
  }
  tokens[owner].first_child = result;
}

/// A rule matches with the elements that stand in `elements`.
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

/// The negated conditions hold: when the rule is added, or again (rete_guard.cpp).
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

MatchId ReteState::AddFixedMatch(std::span<const WmeId> elements, Symbol goal, GoalLevel level,
                                 InstantiationId instantiation) {
  MatchSet::Arrival arrival;
  arrival.production = kNil;
  arrival.elements = elements;
  arrival.goal = goal;
  arrival.level = level;
  std::uint32_t first = kNil;
  for (const WmeId wme : elements) {
    const std::uint32_t token = NewToken(Token::kFixedMatchNode, kNil, Index(wme));
    tokens[token].next_in_bucket = first;
    tokens[token].previous_in_bucket = kNil;
    first = token;
  }
  arrival.token = first;
  const MatchId match = matches.AddFired(arrival, instantiation);
  for (std::uint32_t token = first; token != kNil; token = tokens[token].next_in_bucket) {
    tokens[token].key = Index(match);
  }
  return match;
}

}  // namespace soarbox::kernel
