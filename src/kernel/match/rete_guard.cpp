// SPDX-License-Identifier: BSD-2-Clause
// Justifications with negated conditions. Their positive conditions name the matched elements, so these are stored like
// a fixed match: one token per element. Only the negated conditions have nodes. These are below a separate node that is
// always open, because it negates a condition that no element matches. The end of the chain (a kGuard node) emits the
// rule's match while all of its elements exist.
#include <algorithm>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/match/fixed_match.h"
#include "kernel/match/rete_builder.h"
#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

/// Builds the node above the negations of a rule. Rules never share it: when an element ends the matches of several
/// rules, they must end in the order in which the rules were added.
std::uint32_t ReteBuilder::BuildGuard(std::span<const Condition> negations, std::uint32_t rule) {
  // Identifiers of elements are never words, so no element enters this memory.
  const std::uint32_t nothing[3] = {words::kSuperstate.bits(), words::kSuperstate.bits(), 0};
  constexpr std::uint32_t kMask = 3;
  NodePlan plan;
  plan.parent = 0;
  plan.shape.kind = NodeKind::kNegative;
  plan.digest = rule + 1u;
  plan.alpha = state_.network->FindAlpha(nothing, kMask, true);
  if (plan.alpha != kNil) {
    state_.network->UseAlpha(plan.alpha);
  } else {
    plan.alpha = state_.network->AddAlpha(nothing, kMask, true);
    state_.alphas.Begin(plan.alpha);
  }
  const std::uint32_t top = Make(plan, plan.Hash());
  const std::uint32_t bottom = BuildAll(negations, top, 1);
  Unbind(0);
  return bottom;
}

/// Whether a new rule is a justification with negated conditions whose elements all exist.
bool ReteBuilder::CanBeGuarded(const RuleInfo& info, const Rete::AddOptions& options) const {
  const Production& rule = *info.rule;
  return rule.type == ProductionType::kJustification && info.positives != 0 &&
         info.positives < rule.conditions.size() && options.refracted.size() == info.positives &&
         std::ranges::all_of(std::span(rule.conditions).first(info.positives),
                             [](const Condition& condition) { return condition.kind == ConditionKind::kPositive; }) &&
         std::ranges::all_of(options.refracted, [this](WmeId wme) { return state_.links[Index(wme)].in_match; });
}

/// Builds the nodes of a guarded rule. Returns false, without any change, if a negated condition is not satisfied.
bool ReteBuilder::AddGuarded(const std::shared_ptr<RuleInfo>& info, std::uint32_t number,
                             const Rete::AddOptions& options) {
  NodePlan plan;
  plan.parent = BuildGuard(std::span(info->rule->conditions).subspan(info->positives), number);
  if (state_.emissions().Of(plan.parent).empty()) {
    RemoveUnused(plan.parent);
    return false;
  }
  plan.shape.kind = NodeKind::kGuard;
  plan.digest = number + 1u;
  plan.rule = number;
  const std::uint32_t node = state_.network->AddNode(plan, plan.Hash());
  EnterRule(info, number, node);
  state_.nodes[node].first_linked =
      MakeElementTokens(state_.tokens, state_.links, options.refracted, node, Token::kGuarded);
  return true;
}

/// An element that a guarded rule matched is leaving: the rule never matches again. Its nodes exist until the rule is
/// excised, which may be much later if its results have o-support. Therefore the token at the top of its negations is
/// removed, too: without tokens, the nodes are linked to no alpha memory, and later elements do not reach them.
void ReteState::GuardedElementGone(std::uint32_t node) {
  FreeElementTokens(tokens, links, std::exchange(nodes[node].first_linked, kNil));
  RemoveTokens(BelowRoot(*network, node));
}

}  // namespace soarbox::kernel
