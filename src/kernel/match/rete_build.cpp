// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "kernel/base/sole_owner.h"
#include "kernel/match/rete_builder.h"
#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

// Rules ---------------------------------------------------------------------------------------------------------------

void ReteState::OwnNetwork() {
  if (!IsSoleOwner(network)) {
    network = std::make_shared<Network>(*network);
  }
}

std::uint32_t ReteState::TakeRuleNumber() {
  std::erase_if(excised, [this](std::uint32_t number) {
    if (matches.LiveCount(number) != 0) {
      return false;
    }
    retired[number].reset();
    free_rules.push_back(number);
    return true;
  });
  if (free_rules.empty()) {
    return network->rule_limit();
  }
  const std::uint32_t number = free_rules.back();
  free_rules.pop_back();
  return number;
}

Rete::Added ReteState::AddProduction(ProductionPtr production, const Rete::AddOptions& options) {
  OwnNetwork();
  auto info = std::make_shared<RuleInfo>(std::move(production));
  const Production& rule = *info->rule;
  if (CanBeGuarded(*info, options)) [[unlikely]] {
    const std::uint32_t number = TakeRuleNumber();
    if (AddGuarded(info, number, options)) {
      MatchNewRule(network->rule(number)->node, options);
      return {Rete::AddResult::kAdded, static_cast<ProductionId>(number), refracted_match};
    }
    GiveBackRuleNumber(number);
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

  const std::uint32_t number = TakeRuleNumber();
  plan.rule = number;
  const std::uint32_t made = network->AddNode(plan, hash);
  EnterRule(info, number, made);
  MatchNewRule(made, options);
  return {Rete::AddResult::kAdded, static_cast<ProductionId>(number),
          options.refracted.empty() ? MatchId::kNone : refracted_match};
}

void ReteState::EnterRule(const std::shared_ptr<RuleInfo>& info, std::uint32_t number, std::uint32_t node) {
  info->node = node;
  network->AddRule(number, info);
  matches.RuleAdded(number, info->positives, info->rule->interrupt);
  if (elements.size() < info->positives) {
    elements.resize(info->positives);
  }
  if (number < shared_operators.size()) {
    shared_operators[number] = SharedOperator();
  }
  NodeAdded(node);
}

void ReteState::MatchNewRule(std::uint32_t node, const Rete::AddOptions& options) {
  if (!options.refracted.empty()) {
    refracting_node = node;
    refracted = options.refracted;
    refracting_instantiation = options.instantiation;
    refracted_match = MatchId::kNone;
  }
  Prime(node);
  refracting_node = kNil;
}

void ReteState::ExciseProduction(std::uint32_t number) {
  OwnNetwork();
  const std::uint32_t node = network->rule(number)->node;
  excising = true;
  RemoveTokens(node);
  if (network->node(node).kind == NodeKind::kGuard) {
    FreeFixedMatch(std::exchange(nodes[node].first_linked, kNil));
  }
  if (number >= retired.size()) {
    retired.resize(number + 1u);
  }
  retired[number] = network->rule(number)->rule;
  excised.push_back(number);
  network->RemoveRule(number);
  const std::uint32_t bottom = network->node(node).parent;
  RemoveNode(node);
  RemoveUnused(bottom);
  excising = false;
}

// Nodes ---------------------------------------------------------------------------------------------------------------

void ReteState::NodeAdded(std::uint32_t index) {
  while (index >= nodes.size()) {  // Else RemoveNode left its state as good as new.
    marks.emplace_back();
    nodes.emplace_back();
  }
  if (!only_id.empty() && only_id.size() < nodes.size()) {
    only_id.resize(std::max(nodes.size(), only_id.size() * 2));
  }
  ChildAdded(index);
  const Node& node = network->node(index);
  if (node.kind == NodeKind::kNegative) {
    marks[index].Set(NodeMarks::kNegative);
  } else if (node.kind != NodeKind::kMemory && node.kind != NodeKind::kAnchors && node.kind != NodeKind::kPaths) {
    marks[index].Set(NodeMarks::kOther);
  }
  if (node.kind == NodeKind::kAnchors || marks[node.parent].Is(NodeMarks::kInPath)) {
    marks[index].Set(NodeMarks::kInPath);
  }
  if (node.kind == NodeKind::kJoin) {
    if (marks[index].Is(NodeMarks::kInPath)) {
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
  for (const Emission& emission : Emissions(parent)) {
    Left(child, emission.first, emission.second);
  }
}

void ReteState::RemoveTokens(std::uint32_t node) {
  std::vector<std::uint32_t> all;
  ForEachToken(node, [&](std::uint32_t token) { all.push_back(token); });
  for (const std::uint32_t token : all) {
    RemoveSubtree(token);
  }
}

void ReteState::RemoveNode(std::uint32_t index) {
  if (network->node(index).kind == NodeKind::kJoin) {
    MakePlain(network->node(index).parent);
  }
  const NodeMarks has = marks[index];
  if (has.bits() != 0) {
    tables.Free(nodes[index].head, has.bits());
  }
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
  nodes[index] = NodeState();
  marks[index] = NodeMarks();
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
  if (alpha >= alphas.size()) {
    alphas.resize(alpha + 1u);
  }
  alphas[alpha] = AlphaState();
  const auto add_if_fits = [&](std::uint32_t wme) {
    const Wme& element = wmes[wme];
    if (element.acceptable == acceptable && ((mask & 1u) == 0 || element.id.bits() == constants[0]) &&
        ((mask & 2u) == 0 || element.attribute.bits() == constants[1]) &&
        ((mask & 4u) == 0 || element.value.bits() == constants[2])) {
      AddItem(alpha, wme);
    }
  };
  if (general != kNil) {
    for (std::uint32_t item = alphas[general].first; item != kNil; item = items[item].next) {
      add_if_fits(items[item].wme);
    }
  } else {
    for (std::uint32_t wme = newest_wme; wme != kNil; wme = links[wme].next) {
      add_if_fits(wme);
    }
  }
  return alpha;
}

void ReteState::DropAlpha(std::uint32_t alpha) {
  if (!network->DropAlpha(alpha)) {
    return;
  }
  AlphaState& memory = alphas[alpha];
  for (std::uint32_t index = memory.first; index != kNil;) {
    AlphaItem& item = items[index];
    const std::uint32_t next = item.next;
    std::uint32_t* link = &links[item.wme].first_item;
    while (*link != index) {
      link = &items[*link].next_of_wme;
    }
    *link = item.next_of_wme;
    item.next = free_items;
    free_items = index;
    index = next;
  }
  if (memory.id_bits != 0) {
    tables.Free(memory.id_table, memory.id_bits);
  }
  if (memory.pair_bits != 0) {
    tables.Free(memory.pair_table, memory.pair_bits);
  }
  memory = AlphaState();
}

}  // namespace soarbox::kernel
