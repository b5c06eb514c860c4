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
      passed = GoalLevelOf(Symbol::FromBits(value)) != 0;
      break;
    case TestOp::kNever:
      passed = false;
      break;
    case TestOp::kSameLti:
    case TestOp::kNotSameLti: {
      const Symbol other = Symbol::FromBits(referent);
      const std::uint64_t lti = LtiOf(Symbol::FromBits(value));
      const std::uint64_t wanted =
          other.IsInteger() ? static_cast<std::uint64_t>(symbols.IntegerValue(other)) : LtiOf(other);
      passed = (lti != 0 && lti == wanted) == (test.op == TestOp::kSameLti);
      break;
    }
    case TestOp::kIsLti:
      passed = LtiOf(Symbol::FromBits(value)) != 0;
      break;
    case TestOp::kIsNotLti:
      passed = LtiOf(Symbol::FromBits(value)) == 0;
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

// Alpha memories ------------------------------------------------------------------------------------------------------

void ReteState::AddItem(std::uint32_t alpha, std::uint32_t wme) {
  InsertItem(*this, alpha, wme);
}

// Both walk from the oldest item, so that each bucket is newest first again.
void ReteState::BuildIdTable(std::uint32_t alpha, std::uint8_t bits) {
  AlphaState& memory = alphas[alpha];
  while (memory.count > 1u << bits) {
    ++bits;
  }
  if (memory.id_bits != 0) {
    tables.Free(memory.id_table, memory.id_bits);
  }
  memory.id_table = tables.Allocate(bits);
  memory.id_bits = bits;
  std::uint32_t index = memory.first;
  while (index != kNil && items[index].next != kNil) {
    index = items[index].next;
  }
  for (; index != kNil; index = items[index].previous) {
    std::uint32_t& head = tables[memory.id_table + Hash(items[index].id, bits)];
    items[index].previous_in_bucket = kNil;
    items[index].next_in_bucket = head;
    if (head != kNil) {
      items[head].previous_in_bucket = index;
    }
    head = index;
  }
}

void ReteState::BuildPairTable(std::uint32_t alpha, std::uint8_t bits) {
  AlphaState& memory = alphas[alpha];
  while (memory.count > 1u << bits) {
    ++bits;
  }
  if (memory.pair_bits != 0) {
    tables.Free(memory.pair_table, memory.pair_bits);
  }
  memory.pair_table = tables.Allocate(bits);
  memory.pair_bits = bits;
  std::uint32_t index = memory.first;
  while (index != kNil && items[index].next != kNil) {
    index = items[index].next;
  }
  for (; index != kNil; index = items[index].previous) {
    std::uint32_t& head = tables[memory.pair_table + Hash(PairKey(items[index].id, items[index].value), bits)];
    items[index].next_in_pair = head;
    head = index;
  }
}

// Tokens --------------------------------------------------------------------------------------------------------------

std::uint32_t ReteState::NewToken(std::uint32_t node, std::uint32_t parent, std::uint32_t wme) {
  return MakeToken(*this, node, parent, wme);
}

std::uint32_t ReteState::KeyOfToken(const Node& memory, std::uint32_t token) const {
  return KeyOfPair(*this, memory, tokens[token].parent, tokens[token].wme).key;
}

// Each bucket is split in place, oldest token first, so that tokens with equal keys stay newest first.
void ReteState::GrowBuckets(std::uint32_t node) {
  NodeState& state = nodes[node];
  const std::uint32_t old_bits = marks[node].bits();
  const std::uint32_t old_head = state.head;
  const std::uint32_t bits = old_bits == 0 ? 4 : old_bits + 2;
  const std::uint32_t table = tables.Allocate(bits);
  for (std::uint32_t n = 0; n < 1u << old_bits; ++n) {
    std::uint32_t index = old_bits == 0 ? old_head : tables[old_head + n];
    while (index != kNil && tokens[index].next_in_bucket != kNil) {
      index = tokens[index].next_in_bucket;
    }
    while (index != kNil) {
      Token& token = tokens[index];
      const std::uint32_t previous = token.previous_in_bucket;
      std::uint32_t& head = tables[table + Hash(token.key, bits)];
      token.previous_in_bucket = kNil;
      token.next_in_bucket = head;
      if (head != kNil) {
        tokens[head].previous_in_bucket = index;
      }
      head = index;
      index = previous;
    }
  }
  if (old_bits != 0) {
    tables.Free(old_head, old_bits);
  }
  state.head = table;
  marks[node].SetBits(bits);
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
  InsertWithKey(*this, node_index, token, key.key, node.key != KeyKind::kNone);
  if (nodes[node_index].count == 1) {
    LinkRight(node_index);
  }
  bool blocked = false;
  ForEachRight(*this, node, key, [&](std::uint32_t element) {
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
  for (std::uint32_t token = BucketHead(*this, node_index, key); token != kNil; token = tokens[token].next_in_bucket) {
    if (tokens[token].parent == parent && tokens[token].wme == wme) {
      return;  // Its conjunction matched first and blocks it.
    }
  }
  const std::uint32_t token = NewToken(node_index, parent, wme);
  InsertWithKey(*this, node_index, token, key, true);
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
  std::uint32_t owner = BucketHead(*this, node.partner(), key);
  while (owner != kNil && (tokens[owner].parent != owner_parent || tokens[owner].wme != owner_wme)) {
    owner = tokens[owner].next_in_bucket;
  }
  if (owner == kNil) {
    owner = NewToken(node.partner() | Token::kBlockedBit, owner_parent, owner_wme);
    InsertWithKey(*this, node.partner(), owner, key, true);
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

inline void ReteState::LowestGoal(const RuleInfo& rule, std::span<const WmeId> matched, Symbol& goal,
                                  GoalLevel& level) const {
  const Wme* const table = wmes.data();
  for (const std::uint16_t condition : rule.id_conditions) {
    const Symbol id = table[Index(matched[condition])].id;
    const GoalLevel found = GoalLevelOf(id);
    if (found > level) {
      level = found;
      goal = id;
    }
  }
}

/// Whether a new match is o-supported. As in Soar 9.6.3 all matches that the rule has have a say, the newest first: the
/// new one's actions are held against the operator that each of them tests. What elaborates the operator of one match
/// and changes something else in that or a newer one is called mixed, and i-supported until a still older match
/// objects.
bool ReteState::SupportByMatches(std::uint32_t node, const RuleInfo& rule, const MatchSet::Arrival& arrival) {
  if (arrival.production >= shared_operators.size()) {
    shared_operators.resize(arrival.production + 1u);
  }
  if (rule.Proposes(arrival.elements, wmes, goals.level_of_goal)) {
    shared_operators[arrival.production] = SharedOperator();
    return false;
  }
  const auto tell = [&] {
    if (on_mixed_support) {
      on_mixed_support(static_cast<ProductionId>(arrival.production));
    }
  };
  const RuleInfo::OperatorUse own = rule.UseOfOperator(arrival.elements, arrival.goal, arrival.elements, wmes);
  SharedOperator& shared = shared_operators[arrival.production];
  const std::uint32_t goals_removed = matches.goals_removed();
  const NodeState& state = nodes[node];
  const bool has_a_say = own.elaborates || own.applies;
  if (state.count == 0) {
    shared = {own.selected, goals_removed, !has_a_say};
  }
  // Rules with many matches stay linear: what none of them objects to is not asked of each.
  if (!has_a_say && shared.none_has_a_say && shared.goals_removed == goals_removed) {
    return false;
  }
  if (own.selected && shared.selected == own.selected && shared.goals_removed == goals_removed) {
    if (!own.elaborates || !own.applies || mixed_is_o) {
      return own.applies;
    }
    for (std::uint32_t other = 0; other <= state.count; ++other) tell();
    return false;
  }
  bool applies = false;
  const auto consider = [&](const RuleInfo::OperatorUse& use) {
    applies |= use.applies;
    if (applies && use.elaborates && !mixed_is_o) {
      applies = false;
      tell();
    }
  };
  consider(own);
  bool alike = true;
  bool none_has_a_say = !has_a_say;
  for (std::uint32_t token = state.head; token != kNil; token = tokens[token].next_in_bucket) {
    const std::span<const WmeId> tested = matches.Wmes(static_cast<MatchId>(tokens[token].key));
    Symbol goal;
    GoalLevel level = 0;
    LowestGoal(rule, tested, goal, level);
    const RuleInfo::OperatorUse use = rule.UseOfOperator(tested, goal, arrival.elements, wmes);
    consider(use);
    alike &= use.selected == own.selected;
    none_has_a_say &= !use.elaborates && !use.applies;
  }
  shared = {alike ? own.selected : Symbol(), goals_removed, none_has_a_say};
  return applies;
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
  if (matches.MayReturn(production) && node_index != refracting_node) {
    match = matches.Revive(arrival, wmes);
  }
  if (match != MatchId::kNone) {
    if (production < shared_operators.size()) {
      shared_operators[production] = SharedOperator();
    }
  } else {
    LowestGoal(rule, arrival.elements, arrival.goal, arrival.level);
    arrival.o_support = rule.support == RuleInfo::Support::kByMatch ? SupportByMatches(node_index, rule, arrival)
                                                                    : rule.support == RuleInfo::Support::kO;
    if (node_index == refracting_node && refracted_match == MatchId::kNone &&
        std::ranges::equal(refracted, arrival.elements)) {
      match = refracted_match = matches.AddFired(arrival, refracting_instantiation);
    } else {
      match = matches.Assert(arrival);
    }
  }
  InsertInList(*this, nodes[node_index], token, Index(match));
}

void ReteState::LeftProduction(std::uint32_t node_index, std::uint32_t parent, std::uint32_t wme) {
  const std::uint32_t production = network->node(node_index).rule();
  const RuleInfo& rule = *network->rule(production);
  WmeId* const first = elements.data();
  WmeId* place = first + rule.positives;
  if (wme != kNil) {
    *--place = static_cast<WmeId>(wme);
  }
  const Records<const Token> all = std::as_const(tokens).records();
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
