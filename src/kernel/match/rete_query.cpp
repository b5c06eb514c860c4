// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

namespace {

/// The node of a condition, and the node that emits the partial matches that reach it.
struct Place {
  std::uint32_t node = kNil;
  std::uint32_t before = kNil;
  std::uint32_t conjunctive = kNil;  ///< Set if the condition is part of a shared conjunction.
  bool first = false;  ///< It is the first condition there: the partial matches that reach it are those that reach the
                       ///< conjunction.
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

/// The emissions of a node that were not withdrawn, oldest first. For a node of a shared conjunction, as if it were
/// matched below each token that waits for the conjunction.
Rete::PartialMatches Describe(const ReteState& state, std::uint32_t node, std::uint32_t conjunctive) {
  Rete::PartialMatches found;
  if (node == kNil) {
    return found;
  }
  const auto emissions = state.emissions().Of(node);
  const auto append = [&](std::uint32_t owner, const Emission& emission) {
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
    for (const std::uint32_t owner : state.emissions().OwnersOf(conjunctive, node, it->first, it->second)) {
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
  return place.node == kNil ? 0 : state_->emissions().Of(place.node).size();
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
    // Continues with the nodes of the conjunction. They lead up to the node before it.
    node = n.kind == NodeKind::kConjunctive ? network.node(n.partner()).parent : n.parent;
  }
  return count;
}

}  // namespace soarbox::kernel
