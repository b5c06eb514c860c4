// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "kernel/base/sole_owner.h"
#include "kernel/match/rete_builder.h"
#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

// Rules ---------------------------------------------------------------------------------------------------------------

void ReteState::OwnNetwork() {
  if (IsSoleOwner(network)) {
    network->BeginChange();
    return;
  }
  // One of two owners is the store of shared rules (decide/rule_sharing.h).
  network = network->Fork(network.use_count() > 2);
}

Rete::Added ReteState::AddProduction(ProductionPtr production, const Rete::AddOptions& options) {
  OwnNetwork();
  auto info = std::make_shared<RuleInfo>(std::move(production));
  const Production& rule = *info->rule;
  if (CanBeGuarded(*info, options)) [[unlikely]] {
    const std::uint32_t number = rules.Take(matches, network->rule_limit());
    if (AddGuarded(info, number, options)) {
      MatchNewRule(network->rule(number)->node, options);
      return {Rete::AddResult::kAdded, static_cast<ProductionId>(number), refraction.match};
    }
    rules.GiveBack(number, network->rule_limit());
  }
  const std::uint32_t bottom = builder->Build(rule.conditions);

  NodePlan plan;
  plan.parent = bottom;
  plan.shape.kind = NodeKind::kProduction;
  plan.digest = ActionsDigest(rule);
  const std::uint32_t hash = plan.Hash();
  for (std::uint32_t other = network->FindProduction(plan, hash); other != kNil;
       other = network->FindProduction(plan, hash, other)) {
    const std::uint32_t number = network->node(other).rule();
    if (SameActions(*network->rule(number)->rule, rule, options.ignore_rl_value)) {
      return {Rete::AddResult::kDuplicate, static_cast<ProductionId>(number), MatchId::kNone};
    }
  }

  const std::uint32_t number = rules.Take(matches, network->rule_limit());
  plan.rule = number;
  const std::uint32_t made = network->AddNode(plan, hash);
  EnterRule(info, number, made);
  MatchNewRule(made, options);
  return {Rete::AddResult::kAdded, static_cast<ProductionId>(number),
          options.refracted.empty() ? MatchId::kNone : refraction.match};
}

void ReteState::EnterRule(const std::shared_ptr<RuleInfo>& info, std::uint32_t number, std::uint32_t node) {
  info->node = node;
  network->AddRule(number, info);
  matches.RuleAdded(number, info->positives, info->rule->interrupt);
  if (elements.size() < info->positives) {
    elements.resize(info->positives);
  }
  support.Forget(number);
  NodeAdded(node);
}

void ReteState::MatchNewRule(std::uint32_t node, const Rete::AddOptions& options) {
  if (!options.refracted.empty()) {
    refraction = {node, options.refracted, options.instantiation, MatchId::kNone};
  }
  Prime(node);
  refraction.node = kNil;
}

void ReteState::ExciseProduction(std::uint32_t number) {
  OwnNetwork();
  const std::uint32_t node = network->rule(number)->node;
  excising = true;
  RemoveTokens(node);
  if (network->node(node).kind == NodeKind::kGuard) {
    FreeFixedMatch(std::exchange(nodes[node].first_linked, kNil));
  }
  rules.Retire(number, network->rule(number)->rule);
  network->RemoveRule(number);
  const std::uint32_t bottom = network->node(node).parent;
  RemoveNode(node);
  RemoveUnused(bottom);
  excising = false;
}

// Nodes ---------------------------------------------------------------------------------------------------------------

void ReteState::NodeAdded(std::uint32_t index) {
  nodes.MakeRoom(index + 1u);  // Else RemoveNode left its state as good as new.
  only_ids.MakeRoom(nodes.size());
  ChildAdded(index);
  const Node& node = network->node(index);
  if (node.kind == NodeKind::kNegative) {
    nodes.marks(index).Set(NodeMarks::kNegative);
  } else if (node.kind != NodeKind::kMemory && node.kind != NodeKind::kAnchors && node.kind != NodeKind::kPaths) {
    nodes.marks(index).Set(NodeMarks::kOther);
  }
  if (node.kind == NodeKind::kAnchors || nodes.marks(node.parent).Is(NodeMarks::kInPath)) {
    nodes.marks(index).Set(NodeMarks::kInPath);
  }
  if (node.kind == NodeKind::kJoin) {
    if (nodes.marks(index).Is(NodeMarks::kInPath)) {
      alphas[node.alpha].sparse |= AlphaState::kInPaths;
    }
    const bool has_tokens = nodes[node.parent].count != 0;
    if (!has_tokens || alphas[node.alpha].count != 0) {
      LinkLeft(index);
    }
    if (has_tokens) {
      LinkRight(index);
      NoteNodes(node.alpha);
    }
  }
}

/// Hands a new node what its parent has emitted so far, newest first.
void ReteState::Prime(std::uint32_t child) {
  const std::uint32_t parent = network->node(child).parent;
  if (network->node(parent).kind == NodeKind::kMemory || network->node(parent).kind == NodeKind::kAnchors) {
    return;  // A join emits when it gets children.
  }
  std::vector<Emission> all = std::exchange(primed, {});
  all.clear();
  AddEmissions(parent, all);
  for (const Emission& emission : all) {
    Left(child, emission.first, emission.second);
  }
  primed = std::move(all);
}

void ReteState::RemoveTokens(std::uint32_t node) {
  std::vector<std::uint32_t> all;
  nodes.ForEachToken(tokens, node, [&](std::uint32_t token) { all.push_back(token); });
  for (const std::uint32_t token : all) {
    RemoveSubtree(token);
  }
}

void ReteState::RemoveNode(std::uint32_t index) {
  if (network->node(index).kind == NodeKind::kJoin) {
    MakePlain(network->node(index).parent);
  }
  const NodeMarks has = nodes.marks(index);
  if (has.Is(NodeMarks::kLeftLinked)) {
    UnlinkLeft(index);
  }
  if (has.Is(NodeMarks::kRightLinked)) {
    UnlinkRight(index);
  }
  const std::uint32_t alpha = network->node(index).alpha;
  network->RemoveNode(index);
  if (alpha != kNil) {
    DropAlpha(alpha);
  }
  nodes.Reset(index);
}

/// Removes a node without children, and what that leaves without children above it.
void ReteState::RemoveUnused(std::uint32_t index) {
  while (index != 0 && network->node(index).first_child == kNil) {
    const Node& node = network->node(index);
    std::uint32_t next = node.parent;
    if (node.kind != NodeKind::kJoin) {
      RemoveTokens(index);
    }
    if (node.kind == NodeKind::kConjunctive) {
      const std::uint32_t partner = node.partner();
      next = network->node(partner).parent;  // Leads up to this node's own parent.
      RemoveNode(partner);
    }
    const bool was_join = node.kind == NodeKind::kJoin;
    RemoveNode(index);
    if (was_join) {
      builder->JoinRemoved(next);
    }
    index = next;
  }
}

// Alpha memories ------------------------------------------------------------------------------------------------------

// Filled from the next more general memory or from all elements, newest first; each becomes the first item.
std::uint32_t ReteState::MakeAlpha(const std::uint32_t (&constants)[3], std::uint32_t mask, bool acceptable) {
  std::uint32_t alpha = network->FindAlpha(constants, mask, acceptable);
  if (alpha != kNil) {
    network->UseAlpha(alpha);
    return alpha;
  }
  std::uint32_t general = kNil;
  for (const std::uint32_t drop : {1u, 4u, 5u}) {
    const std::uint32_t rest = mask & ~drop;
    if (rest != mask && general == kNil) {
      const std::uint32_t fewer[3] = {(rest & 1u) ? constants[0] : 0, constants[1], (rest & 4u) ? constants[2] : 0};
      general = network->FindAlpha(fewer, rest, acceptable);
    }
  }
  alpha = network->AddAlpha(constants, mask, acceptable);
  alphas.Begin(alpha);
  const auto add_if_fits = [&](std::uint32_t wme) {
    const Wme& element = wmes[wme];
    if (element.acceptable == acceptable && ((mask & 1u) == 0 || element.id.bits() == constants[0]) &&
        ((mask & 2u) == 0 || element.attribute.bits() == constants[1]) &&
        ((mask & 4u) == 0 || element.value.bits() == constants[2])) {
      alphas.Insert(alpha, wme, element, links[wme].first_item);
    }
  };
  if (general != kNil) {
    for (std::uint32_t item = alphas[general].first; item != kNil; item = alphas.item(item).next) {
      add_if_fits(alphas.item(item).wme);
    }
  } else {
    for (std::uint32_t wme = links.newest(); wme != kNil; wme = links[wme].next) {
      add_if_fits(wme);
    }
  }
  alphas[alpha].sparse |= alphas[alpha].count > 1 ? AlphaState::kPrimed : 0;
  return alpha;
}

void ReteState::DropAlpha(std::uint32_t alpha) {
  if (network->DropAlpha(alpha)) {
    alphas.Drop(alpha, links);
  }
}

}  // namespace soarbox::kernel
