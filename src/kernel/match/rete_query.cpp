// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

std::vector<std::uint32_t> ReteState::TokensByAge(std::uint32_t node) const {
  std::vector<std::uint32_t> found;
  found.reserve(nodes[node].count);
  nodes.ForEachToken(tokens, node, [&](std::uint32_t token) { found.push_back(token); });
  std::sort(found.begin(), found.end(),
            [this](std::uint32_t a, std::uint32_t b) { return tokens[a].serial > tokens[b].serial; });
  return found;
}

/// What a node has emitted and not withdrawn, newest first.
std::vector<ReteState::Emission> ReteState::Emissions(std::uint32_t index) const {
  std::vector<Emission> emissions;
  AddEmissions(index, emissions);
  return emissions;
}

void ReteState::AddEmissions(std::uint32_t index, std::vector<Emission>& emissions) const {
  const Node& node = network->node(index);
  switch (node.kind) {
    case NodeKind::kRoot:
      emissions.emplace_back(kNil, kNil);
      break;
    case NodeKind::kJoin: {
      if (nodes[node.parent].count == 0) {
        break;
      }
      if (nodes[node.parent].count == 1 && alphas[node.alpha].id_bits != 0 && node.IsJoinById() &&
          nodes.marks(node.parent).HasList()) {
        // With one token the elements are found from the left.
        const std::uint32_t token = nodes[node.parent].head;
        const std::uint32_t id = tokens[token].key;
        const AlphaState& alpha = alphas[node.alpha];
        for (std::uint32_t item = alphas.IdBucket(alpha, id); item != kNil; item = alphas.item(item).next_in_bucket) {
          if (alphas.item(item).id == id && Passes(node, token, wmes[alphas.item(item).wme])) {
            emissions.emplace_back(token, alphas.item(item).wme);
          }
        }
        break;
      }
      for (std::uint32_t item = alphas[node.alpha].first; item != kNil; item = alphas.item(item).next) {
        const std::uint32_t wme = alphas.item(item).wme;
        const std::uint32_t key = KeyOfElement(node, wmes[wme]);
        const std::size_t first = emissions.size();
        for (std::uint32_t token = nodes.BucketHead(node.parent, key); token != kNil;
             token = tokens[token].next_in_bucket) {
          if (tokens[token].key == key && HasKey(*this, node, token, wmes[wme]) && Passes(node, token, wmes[wme])) {
            emissions.emplace_back(token, wme);
          }
        }
        if (nodes.marks(node.parent).Is(NodeMarks::kSparse)) {  // Its buckets may be out of order.
          std::sort(
              emissions.begin() + static_cast<std::ptrdiff_t>(first), emissions.end(),
              [this](const Emission& a, const Emission& b) { return tokens[a.first].serial > tokens[b.first].serial; });
        }
      }
      break;
    }
    case NodeKind::kNegative:
      for (const std::uint32_t token : TokensByAge(index)) {
        const std::uint32_t child = tokens[token].first_child;
        if (child == kNil || (tokens[child].node & Token::kResultBit) == 0) {
          emissions.emplace_back(token, kNil);
        }
      }
      break;
    case NodeKind::kConjunctive:
      for (const std::uint32_t token : TokensByAge(index)) {
        if ((tokens[token].node & Token::kBlockedBit) == 0) {
          emissions.emplace_back(token, kNil);
        }
      }
      break;
    case NodeKind::kFree:
    case NodeKind::kMemory:
    case NodeKind::kPartner:
    case NodeKind::kAnchors:
    case NodeKind::kPaths:
    case NodeKind::kProduction:
    case NodeKind::kGuard:
      break;
  }
}

/// The owners, oldest first, for which (parent, wme), emitted by a join of the conjunction, is a partial match.
std::vector<std::uint32_t> ReteState::OwnersOf(std::uint32_t conjunctive, std::uint32_t join, std::uint32_t parent,
                                               std::uint32_t wme) const {
  const Network& net = *network;
  const Node& node = net.node(conjunctive);
  std::uint32_t below = 0;  // Conditions of the conjunction behind this one.
  for (std::uint32_t n = net.node(net.node(node.partner()).parent).parent; n != join; ++below) {
    n = net.node(net.node(n).parent).parent;
  }
  const std::uint32_t anchor = tokens.TopOf(parent);
  const auto passes = [&](std::uint32_t owner) {
    const Token& left = tokens[owner];
    return left.pairs == anchor && std::ranges::all_of(net.tests(node), [&](const NodeTest& test) {
             if (test.count < below) {
               return true;  // Of a condition that comes later.
             }
             const Wme& element = wmes.data()[ElementAt(tokens.records(), parent, wme, test.count - below)];
             return PassesOne(test, left.parent, left.wme, element);
           });
  };
  std::vector<std::uint32_t> owners = TokensByAge(conjunctive);
  std::erase_if(owners, [&](std::uint32_t owner) { return !passes(owner); });
  std::reverse(owners.begin(), owners.end());
  return owners;
}

namespace {

/// The node that a condition was made into, and the node that emits what reaches it.
struct Place {
  std::uint32_t node = kNil;
  std::uint32_t before = kNil;
  std::uint32_t conjunctive = kNil;  ///< If the condition is part of a shared conjunction.
  bool first = false;                ///< And the first there: what reaches it is what reaches the conjunction.
};

Place PlaceOf(const Network& network, const RuleInfo& rule, std::span<const std::uint16_t> path) {
  std::uint32_t emitter = network.node(rule.node).parent;
  std::span<const Condition> conditions = rule.rule->conditions;
  std::uint32_t conjunctive = kNil;
  for (std::size_t step = 0; step < path.size(); ++step) {
    if (path[step] >= conditions.size()) {
      return {};
    }
    Place place;
    for (std::size_t n = conditions.size(); n-- > path[step];) {
      place.node = emitter;
      place.before = network.node(emitter).parent;
      if (network.node(emitter).kind == NodeKind::kJoin) {
        place.before = network.node(place.before).parent;
      }
      emitter = place.before;
    }
    if (step + 1 == path.size()) {
      place.conjunctive = conjunctive;
      place.first = path[step] == 0;
      return place;
    }
    const Condition& condition = conditions[path[step]];
    if (condition.kind != ConditionKind::kConjunctiveNegation) {
      return {};
    }
    emitter = network.node(network.node(place.node).partner()).parent;
    conjunctive = kNil;
    if (network.node(emitter).kind == NodeKind::kPaths) {
      emitter = network.node(emitter).parent;
      conjunctive = place.node;
    }
    conditions = condition.conditions();
  }
  return {};
}

}  // namespace

const RuleInfo* RuleOf(const ReteState& state, ProductionId production) {
  return Index(production) < state.network->rule_limit() ? state.network->rule(Index(production)).get() : nullptr;
}

/// Appends the elements of a token, first condition first.
void AppendElements(const ReteState& state, std::uint32_t token, std::vector<WmeId>& match) {
  const auto first = static_cast<std::ptrdiff_t>(match.size());
  for (; token != kNil; token = state.tokens[token].parent) {
    if (state.tokens[token].wme != kNil) {
      match.push_back(static_cast<WmeId>(state.tokens[token].wme));
    }
  }
  std::reverse(match.begin() + first, match.end());
}

/// What a node has emitted and not withdrawn, oldest first. A node of a shared conjunction: for each token that waits
/// for the conjunction, as if it were matched below it.
Rete::PartialMatches Describe(const ReteState& state, std::uint32_t node, std::uint32_t conjunctive) {
  Rete::PartialMatches found;
  if (node == kNil) {
    return found;
  }
  const auto emissions = state.Emissions(node);
  const auto append = [&](std::uint32_t owner, const ReteState::Emission& emission) {
    std::vector<WmeId>& match = found.emplace_back();
    AppendElements(state, owner, match);
    AppendElements(state, emission.first, match);
    if (emission.second != kNil) {
      match.push_back(static_cast<WmeId>(emission.second));
    }
  };
  for (auto it = emissions.rbegin(); it != emissions.rend(); ++it) {
    if (conjunctive == kNil) {
      append(kNil, *it);
      continue;
    }
    for (const std::uint32_t owner : state.OwnersOf(conjunctive, node, it->first, it->second)) {
      append(owner, *it);
    }
  }
  return found;
}

Place PlaceIn(const ReteState& state, ProductionId production, std::span<const std::uint16_t> path) {
  const RuleInfo* rule = RuleOf(state, production);
  return rule ? PlaceOf(*state.network, *rule, path) : Place();
}

std::size_t Rete::CountAfter(ProductionId production, std::span<const std::uint16_t> path) const {
  const Place place = PlaceIn(*state_, production, path);
  if (place.conjunctive != kNil) {
    return MatchesAfter(production, path).size();
  }
  return place.node == kNil ? 0 : state_->Emissions(place.node).size();
}

Rete::PartialMatches Rete::MatchesAfter(ProductionId production, std::span<const std::uint16_t> path) const {
  const Place place = PlaceIn(*state_, production, path);
  return Describe(*state_, place.node, place.conjunctive);
}

Rete::PartialMatches Rete::MatchesBefore(ProductionId production, std::span<const std::uint16_t> path) const {
  const Place place = PlaceIn(*state_, production, path);
  return Describe(*state_, place.before, place.first ? kNil : place.conjunctive);
}

std::vector<WmeId> Rete::RightMatches(ProductionId production, std::span<const std::uint16_t> path) const {
  std::vector<WmeId> found;
  const std::uint32_t node = PlaceIn(*state_, production, path).node;
  if (node == kNil || state_->network->node(node).alpha == kNil) {
    return found;
  }
  const AlphaState& memory = state_->alphas[state_->network->node(node).alpha];
  for (std::uint32_t item = memory.first; item != kNil; item = state_->alphas.item(item).next) {
    found.push_back(static_cast<WmeId>(state_->alphas.item(item).wme));
  }
  return found;
}

std::size_t Rete::CountTokens(ProductionId production, bool complete) const {
  const RuleInfo* rule = RuleOf(*state_, production);
  if (rule == nullptr) {
    return 0;
  }
  const Network& network = *state_->network;
  std::size_t count = complete ? state_->nodes[rule->node].count : 0;
  for (std::uint32_t node = network.node(rule->node).parent; node != kNil;) {
    const Node& n = network.node(node);
    if (n.kind == NodeKind::kMemory || n.kind == NodeKind::kNegative || n.kind == NodeKind::kConjunctive ||
        n.kind == NodeKind::kAnchors || n.kind == NodeKind::kPaths) {
      count += state_->nodes[node].count;
    }
    // The conjunction hangs below what comes before it, so that its nodes lead on upwards.
    node = n.kind == NodeKind::kConjunctive ? network.node(n.partner()).parent : n.parent;
  }
  return count;
}

}  // namespace soarbox::kernel
