// SPDX-License-Identifier: BSD-2-Clause
// Adds rules to the network and removes them.
#include <utility>

#include "kernel/match/fixed_match.h"
#include "kernel/match/rete_builder.h"
#include "kernel/match/rete_state.h"

namespace soarbox::kernel {

Rete::Added ReteBuilder::AddProduction(ProductionPtr production, const Rete::AddOptions& options) {
  Network::Own(state_.network);
  auto info = std::make_shared<RuleInfo>(std::move(production));
  const Production& rule = *info->rule;
  if (CanBeGuarded(*info, options)) [[unlikely]] {
    const std::uint32_t number = state_.rules.Take(state_.matches, state_.network->rule_limit());
    if (AddGuarded(info, number, options)) {
      MatchNewRule(state_.network->rule(number)->node, options);
      return {Rete::AddResult::kAdded, static_cast<ProductionId>(number), state_.refraction.match};
    }
    state_.rules.GiveBack(number, state_.network->rule_limit());
  }
  const std::uint32_t bottom = Build(rule.conditions);

  NodePlan plan;
  plan.parent = bottom;
  plan.shape.kind = NodeKind::kProduction;
  plan.digest = ActionsDigest(rule);
  const std::uint32_t hash = plan.Hash();
  for (std::uint32_t other = state_.network->FindProduction(plan, hash); other != kNil;
       other = state_.network->FindProduction(plan, hash, other)) {
    const std::uint32_t number = state_.network->node(other).rule();
    if (SameActions(*state_.network->rule(number)->rule, rule, options.ignore_rl_value)) {
      return {Rete::AddResult::kDuplicate, static_cast<ProductionId>(number), MatchId::kNone};
    }
  }

  const std::uint32_t number = state_.rules.Take(state_.matches, state_.network->rule_limit());
  plan.rule = number;
  const std::uint32_t made = state_.network->AddNode(plan, hash);
  EnterRule(info, number, made);
  MatchNewRule(made, options);
  return {Rete::AddResult::kAdded, static_cast<ProductionId>(number),
          options.refracted.empty() ? MatchId::kNone : state_.refraction.match};
}

void ReteBuilder::EnterRule(const std::shared_ptr<RuleInfo>& info, std::uint32_t number, std::uint32_t node) {
  info->node = node;
  state_.network->AddRule(number, info);
  state_.matches.RuleAdded(number, info->positives, info->rule->interrupt);
  if (state_.elements.size() < info->positives) {
    state_.elements.resize(info->positives);
  }
  state_.support.Forget(number);
  state_.NodeAdded(node);
}

void ReteBuilder::MatchNewRule(std::uint32_t node, const Rete::AddOptions& options) {
  if (!options.refracted.empty()) {
    state_.refraction = {node, options.refracted, options.instantiation, MatchId::kNone};
  }
  state_.Prime(node);
  state_.refraction.node = kNil;
}

void ReteBuilder::ExciseProduction(std::uint32_t number) {
  Network::Own(state_.network);
  const std::uint32_t node = state_.network->rule(number)->node;
  state_.excising = true;
  state_.RemoveTokens(node);
  if (state_.network->node(node).kind == NodeKind::kGuard) {
    FreeElementTokens(state_.tokens, state_.links, std::exchange(state_.nodes[node].first_linked, kNil));
  }
  state_.rules.Retire(number, state_.network->rule(number)->rule);
  state_.network->RemoveRule(number);
  const std::uint32_t bottom = state_.network->node(node).parent;
  state_.RemoveNode(node);
  RemoveUnused(bottom);
  state_.excising = false;
}

/// Removes a node without children, and then the nodes above it that have no children left.
void ReteBuilder::RemoveUnused(std::uint32_t index) {
  while (index != 0 && state_.network->node(index).first_child == kNil) {
    const Node& node = state_.network->node(index);
    std::uint32_t next = node.parent;
    if (node.kind != NodeKind::kJoin) {
      state_.RemoveTokens(index);
    }
    if (node.kind == NodeKind::kConjunctive) {
      const std::uint32_t partner = node.partner();
      next = state_.network->node(partner).parent;  // The conjunction's nodes lead up to this node's parent.
      state_.RemoveNode(partner);
    }
    const bool was_join = node.kind == NodeKind::kJoin;
    state_.RemoveNode(index);
    if (was_join) {
      JoinRemoved(next);
    }
    index = next;
  }
}

}  // namespace soarbox::kernel
