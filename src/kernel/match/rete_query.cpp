// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

std::vector<std::uint32_t> ReteState::TokensByAge(std::uint32_t node) const {
  std::vector<std::uint32_t> found;
  found.reserve(nodes[node].count);
  ForEachToken(node, [&](std::uint32_t token) { found.push_back(token); });
  std::sort(found.begin(), found.end(),
            [this](std::uint32_t a, std::uint32_t b) { return tokens[a].serial > tokens[b].serial; });
  return found;
}

std::size_t ReteState::CountTokens() const {
  std::size_t count = tokens.size();
  for (std::uint32_t token = free_tokens; token != kNil; token = tokens[token].next_sibling) {
    --count;
  }
  return count;
}

/// What a node has emitted and not withdrawn, newest first.
std::vector<ReteState::Emission> ReteState::Emissions(std::uint32_t index) const {
  std::vector<Emission> emissions;
  const Node& node = network->node(index);
  switch (node.kind) {
    case NodeKind::kRoot:
      emissions.emplace_back(kNil, kNil);
      break;
    case NodeKind::kJoin: {
      const NodeState& memory = nodes[node.parent];
      if (memory.count == 0) {
        break;
      }
      for (std::uint32_t item = alphas[node.alpha].first; item != kNil; item = items[item].next) {
        const std::uint32_t wme = items[item].wme;
        const std::uint32_t key = KeyOfElement(node, wmes[wme]);
        const std::size_t first = emissions.size();
        for (std::uint32_t token = ChainHead(*this, memory, key); token != kNil; token = tokens[token].next_in_chain) {
          if (tokens[token].key == key && HasKey(*this, node, token, wmes[wme]) && Passes(node, token, wmes[wme])) {
            emissions.emplace_back(token, wme);
          }
        }
        if ((memory.roles & NodeState::kSparse) != 0) {  // Its chains may be out of order.
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
    case NodeKind::kProduction:
      break;
  }
  return emissions;
}

namespace {

/// The node that a condition was made into, and the node that emits what reaches it.
struct Place {
  std::uint32_t node = kNil;
  std::uint32_t before = kNil;
};

Place PlaceOf(const Network& network, const RuleInfo& rule, std::span<const std::uint16_t> path) {
  std::uint32_t emitter = network.node(rule.node).parent;
  std::span<const Condition> conditions = rule.rule->conditions;
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
      return place;
    }
    const Condition& condition = conditions[path[step]];
    if (condition.kind != ConditionKind::kConjunctiveNegation) {
      return {};
    }
    emitter = network.node(network.node(place.node).partner).parent;
    conditions = condition.conditions();
  }
  return {};
}

}  // namespace

const RuleInfo* RuleOf(const ReteState& state, ProductionId production) {
  return Index(production) < state.network->rule_limit() ? state.network->rule(Index(production)).get() : nullptr;
}

Rete::PartialMatches Describe(const ReteState& state, std::uint32_t node) {
  Rete::PartialMatches found;
  if (node == kNil) {
    return found;
  }
  const auto emissions = state.Emissions(node);
  for (auto it = emissions.rbegin(); it != emissions.rend(); ++it) {
    std::vector<WmeId>& match = found.emplace_back();
    if (it->second != kNil) {
      match.push_back(static_cast<WmeId>(it->second));
    }
    for (std::uint32_t token = it->first; token != kNil; token = state.tokens[token].parent) {
      if (state.tokens[token].wme != kNil) {
        match.push_back(static_cast<WmeId>(state.tokens[token].wme));
      }
    }
    std::reverse(match.begin(), match.end());
  }
  return found;
}

std::size_t Rete::CountAfter(ProductionId production, std::span<const std::uint16_t> path) const {
  const RuleInfo* rule = RuleOf(*state_, production);
  const std::uint32_t node = rule ? PlaceOf(*state_->network, *rule, path).node : kNil;
  return node == kNil ? 0 : state_->Emissions(node).size();
}

Rete::PartialMatches Rete::MatchesAfter(ProductionId production, std::span<const std::uint16_t> path) const {
  const RuleInfo* rule = RuleOf(*state_, production);
  return Describe(*state_, rule ? PlaceOf(*state_->network, *rule, path).node : kNil);
}

Rete::PartialMatches Rete::MatchesBefore(ProductionId production, std::span<const std::uint16_t> path) const {
  const RuleInfo* rule = RuleOf(*state_, production);
  return Describe(*state_, rule ? PlaceOf(*state_->network, *rule, path).before : kNil);
}

std::vector<WmeId> Rete::RightMatches(ProductionId production, std::span<const std::uint16_t> path) const {
  std::vector<WmeId> found;
  const RuleInfo* rule = RuleOf(*state_, production);
  const std::uint32_t node = rule ? PlaceOf(*state_->network, *rule, path).node : kNil;
  if (node == kNil || state_->network->node(node).alpha == kNil) {
    return found;
  }
  const AlphaState& memory = state_->alphas[state_->network->node(node).alpha];
  for (std::uint32_t item = memory.first; item != kNil; item = state_->items[item].next) {
    found.push_back(static_cast<WmeId>(state_->items[item].wme));
  }
  return found;
}

std::size_t Rete::CountTokens(ProductionId production) const {
  const RuleInfo* rule = RuleOf(*state_, production);
  if (rule == nullptr) {
    return 0;
  }
  const Network& network = *state_->network;
  std::size_t count = state_->nodes[rule->node].count;
  for (std::uint32_t node = network.node(rule->node).parent; node != kNil;) {
    const Node& n = network.node(node);
    if (n.kind == NodeKind::kMemory || n.kind == NodeKind::kNegative || n.kind == NodeKind::kConjunctive) {
      count += state_->nodes[node].count;
    }
    // The conjunction hangs below what comes before it, so that its nodes lead on upwards.
    node = n.kind == NodeKind::kConjunctive ? network.node(n.partner).parent : n.parent;
  }
  return count;
}

}  // namespace soarbox::kernel
