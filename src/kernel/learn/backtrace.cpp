// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/backtrace.h"

#include <algorithm>
#include <span>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/descriptions.h"
#include "kernel/decide/firing.h"
#include "kernel/decide/goal_changes.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/production_record.h"
#include "kernel/learn/justification.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/learn/selection_knowledge.h"
#include "kernel/match/rete.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

void Backtracer::Trace(Explanation& out, bool every_condition) {
  out_ = &out;
  every_condition_ = every_condition;
  is_told_ = uses_.observers.Wants(Event::kBacktrace);
  out.firings.clear();
  out.grounds.clear();
  out.links.clear();
  out.superstate_links.clear();
  out.item_tests.clear();
  out.items.clear();
  out.negations.clear();
  out.operator_grounds.clear();
  out.lowest_ground = 0;
  out.quiescence = out.local_negation = out.long_term_memory = false;
  out.drafts.Clear();
  queue_.clear();
  selected_proposal_ = SelectedProposal();
  using Kind = BacktraceStep::Kind;
  for (auto result = out.results.rbegin(); result != out.results.rend(); ++result) {
    Tell({.kind = Kind::kResult, .preference = *result});
    VisitFiring(uses_.memory.preference(*result).instantiation);
  }
  if (uses_.instantiations[out.base].backtrace != out.trace_number) VisitFiring(out.base);
  Tell({.kind = Kind::kLocals});
  // When a firing is visited, its grounds are added immediately. What it depends on in the substate is visited later,
  // the last one first.
  while (!queue_.empty()) {
    const Open open = queue_.back();
    queue_.pop_back();
    if (open.local != WmeId::kNone) Tell({.kind = Kind::kLocal, .local = open.local});
    if (open.firing != InstantiationId::kNone) {
      if (open.link.maker != PreferenceId::kNone) out.links.push_back(open.link);
      VisitFiring(open.firing);
    } else if (open.item != WmeId::kNone) {
      VisitItem(open.item);
    } else {
      Tell({.kind = Kind::kNoMaker});
    }
  }
  Tell({.kind = Kind::kEnd});
  // The grounds and negations that were found last come first in the learned rule.
  std::ranges::reverse(out.grounds);
  std::ranges::reverse(out.negations);
  if (!out.negations.empty()) SortNegations();
  uses_.statistics.backtraced += out.firings.size() + out.items.size();
}

bool Backtracer::Mark(WmeId wme) {
  const std::uint32_t index = Index(wme);
  if (seen_wmes_.size() <= index) seen_wmes_.resize(index + 1u, 0);
  return std::exchange(seen_wmes_[index], out_->trace_number) != out_->trace_number;
}

void Backtracer::VisitSelection(std::uint32_t selection) {
  const std::size_t count = uses_.selections.preferences(selection).size();
  const bool all = uses_.learn.add_selection_knowledge;
  for (std::size_t n = 0; n < count; ++n) {
    const PreferenceId p = uses_.selections.preferences(selection)[n];
    if (!all && uses_.memory.preference(p).type != PreferenceType::kProhibit) continue;
    // (Preferences of higher states' rules that prohibit something do not belong to the substate. They are traced at
    // their level.)
    const bool is_higher = uses_.memory.preference(p).level < out_->level;
    const PreferenceId local = is_higher ? p : uses_.firing.CloneAtLevel(p, out_->level);
    if (local == PreferenceId::kNone) continue;
    Tell({.kind = BacktraceStep::Kind::kSelection, .preference = local});
    VisitFiring(uses_.memory.preference(local).instantiation);
  }
}

InstantiationId Backtracer::SelectedProposal() const {
  if (out_->level > uses_.goals.depth()) return InstantiationId::kNone;
  if (uses_.selections.OfGoal(out_->level) == SelectionKnowledge::kNone) return InstantiationId::kNone;
  const WmeId selected = uses_.memory.slot(uses_.goals.at(out_->level).operator_slot).wmes;
  if (selected == WmeId::kNone) return InstantiationId::kNone;
  const PreferenceId proposal = uses_.memory.record(selected).preference;
  return proposal == PreferenceId::kNone ? InstantiationId::kNone : uses_.memory.preference(proposal).instantiation;
}

void Backtracer::VisitFiring(InstantiationId firing) {
  Instantiation& instantiation = uses_.instantiations[firing];
  if (std::exchange(instantiation.backtrace, out_->trace_number) == out_->trace_number) {
    if (is_told_)
      Tell({.kind = BacktraceStep::Kind::kKnownFiring, .firing = uses_.descriptions.ProductionName(firing)});
    return;
  }
  out_->firings.push_back(firing);
  if (is_told_) [[unlikely]]
    TellOfFiring(firing);
  if (instantiation.justification != Instantiation::kNoJustification) {
    out_->quiescence |= uses_.justifier.record(instantiation.justification).quiescence;
  } else if (instantiation.production == ProductionId::kNone) {
    out_->long_term_memory = true;
  }
  out_->local_negation |= instantiation.local_negation;
  out_->long_term_memory |= instantiation.long_term_memory;
  if (instantiation.selection != SelectionKnowledge::kNone) {
    VisitSelection(instantiation.selection);
  } else if (firing == selected_proposal_) {
    VisitSelection(uses_.selections.OfGoal(out_->level));
  }
  const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(firing);
  for (std::size_t n = 0; n < traces.size(); ++n) VisitCondition(firing, static_cast<std::uint16_t>(n), traces[n]);
  CollectNegations(firing);
}

inline void Backtracer::AddGround(const Explanation::Ground& ground, const Wme& wme) {
  const bool is_new = Mark(ground.wme);
  if (!is_new && !every_condition_) return;
  out_->grounds.push_back(ground);
  if (!is_new) return;
  const GoalLevel goal = uses_.memory.goal_levels()[wme.id.index()];
  if (goal == 0) return;
  out_->lowest_ground = std::max(out_->lowest_ground, goal);
  if (wme.attribute == words::kOperator && !wme.acceptable) out_->operator_grounds.push_back(ground.wme);
}

/// An item of an impasse depends on the proposal in the superstate.
void Backtracer::VisitItem(WmeId item) {
  const WmeId proposal = uses_.goal_changes.ProposalOfItem(item);
  out_->items.push_back(item);
  if (proposal == WmeId::kNone) return;
  Tell({.kind = BacktraceStep::Kind::kItem, .grounds = {&proposal, 1}});
  AddGround({InstantiationId::kNone, 0, proposal, item}, uses_.memory.wme(proposal));
}

inline void Backtracer::VisitCondition(InstantiationId firing, std::uint16_t condition, const ConditionTrace& trace) {
  const WorkingMemory& memory = uses_.memory;
  const Wme& wme = memory.wme(trace.wme);
  // The object may have become a part of a higher state since.
  if (memory.known_identifier(wme.id).level < out_->level) {
    AddGround({firing, condition, trace.wme, WmeId::kNone}, wme);
    return;
  }
  if (trace.preference != PreferenceId::kNone) {
    const InstantiationId maker = memory.preference(trace.preference).instantiation;
    if (every_condition_) {
      queue_.push_back({maker, WmeId::kNone, {firing, condition, trace.preference}, trace.wme});
    } else if (is_told_ || uses_.instantiations[maker].backtrace != out_->trace_number) {
      queue_.push_back({maker, WmeId::kNone, {}, trace.wme});
    }
    return;
  }
  const bool is_item = uses_.goal_changes.ProposalOfItem(trace.wme) != WmeId::kNone;
  if (is_told_ && !is_item) queue_.push_back({InstantiationId::kNone, WmeId::kNone, {}, trace.wme});
  // An element of the architecture, created with the substate.
  if (out_->level < 2 || out_->level > uses_.goals.depth() || wme.id != uses_.goals.at(out_->level).id) return;
  if (wme.attribute == words::kQuiescence) {
    out_->quiescence = true;
  } else if (wme.attribute == words::kSuperstate) {
    if (every_condition_) out_->superstate_links.push_back({firing, condition, PreferenceId::kNone});
  } else if (is_item) {
    if (every_condition_) out_->item_tests.push_back({firing, condition, trace.wme});
    if (Mark(trace.wme)) queue_.push_back({InstantiationId::kNone, trace.wme, {}, trace.wme});
  }
}

// Reporting -----------------------------------------------------------------------------------------------------------

void Backtracer::Tell(const BacktraceStep& step) const {
  uses_.observers.Notify(Event::kBacktrace, [&](Observer& o) { o.OnBacktrace(uses_.agent, step); });
}

void Backtracer::TellOfFiring(InstantiationId firing) {
  std::vector<WmeId> grounds, locals;
  const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(firing);
  for (const ConditionTrace& trace : traces) {
    const Symbol object = uses_.memory.wme(trace.wme).id;
    (uses_.memory.known_identifier(object).level < out_->level ? grounds : locals).push_back(trace.wme);
  }
  Arena drafts;
  RuleDraft negations;
  const ProductionId production = uses_.instantiations[firing].production;
  const ProductionPtr rule = production == ProductionId::kNone ? nullptr : uses_.rete.production(production);
  std::vector<ConditionDraft> negated;
  if (rule != nullptr) {
    for (const Condition& condition : rule->conditions) {
      if (condition.kind == ConditionKind::kPositive) continue;
      negated.push_back(InstantiateNegation(condition, *rule, traces, uses_.memory, drafts));
    }
  }
  for (ConditionDraft& condition : negated) negations.conditions.Add(&condition);
  const ProductionPtr shown = negated.empty() ? nullptr : Production::Make(negations);
  Tell({.kind = BacktraceStep::Kind::kFiring,
        .firing = uses_.descriptions.ProductionName(firing),
        .grounds = grounds,
        .locals = locals,
        .negated = shown.get()});
}

// Negated conditions --------------------------------------------------------------------------------------------------

namespace {

/// The value of a variable in the instantiation, or the none symbol.
Symbol ValueOfVariable(const Production& rule, Symbol variable, std::span<const ConditionTrace> traces,
                       const WorkingMemory& memory) {
  std::size_t positive = 0;
  for (const Condition& condition : rule.conditions) {
    if (condition.kind != ConditionKind::kPositive) continue;
    if (positive >= traces.size()) break;
    const Wme& wme = memory.wme(traces[positive++].wme);
    const auto binds = [&](const Test& test) {
      if (test.kind == TestKind::kEqual) return test.referent() == variable;
      return std::ranges::any_of(
          test.parts(), [&](const Test& part) { return part.kind == TestKind::kEqual && part.referent() == variable; });
    };
    if (binds(condition.id)) return wme.id;
    if (binds(condition.attribute)) return wme.attribute;
    if (binds(condition.value)) return wme.value;
  }
  return {};
}

void InstantiateTest(TestDraft& test, const Production& rule, std::span<const ConditionTrace> traces,
                     const WorkingMemory& memory) {
  if (test.referent.IsVariable()) {
    const Symbol value = ValueOfVariable(rule, test.referent, traces, memory);
    if (value) test.referent = value;
  }
  for (TestDraft& part : test.parts) InstantiateTest(part, rule, traces, memory);
}

void InstantiateCondition(ConditionDraft& condition, const Production& rule, std::span<const ConditionTrace> traces,
                          const WorkingMemory& memory) {
  InstantiateTest(condition.id, rule, traces, memory);
  InstantiateTest(condition.attribute, rule, traces, memory);
  InstantiateTest(condition.value, rule, traces, memory);
  for (ConditionDraft& inner : condition.conditions) InstantiateCondition(inner, rule, traces, memory);
}

}  // namespace

ConditionDraft InstantiateNegation(const Condition& condition, const Production& rule,
                                   std::span<const ConditionTrace> matched, const WorkingMemory& memory, Arena& arena) {
  ConditionDraft copy = ToDraft(condition, arena);
  InstantiateCondition(copy, rule, matched, memory);
  return copy;
}

bool Backtracer::IsReached(const ConditionDraft& condition) {
  if (condition.kind != ConditionKind::kConjunctiveNegation) {
    return std::ranges::find(reached_, EqualitySymbol(condition.id)) != reached_.end();
  }
  // Conditions of a conjunction may link each other's objects.
  const std::size_t outside = reached_.size();
  std::vector<const ConditionDraft*> open;
  for (const ConditionDraft& inner : condition.conditions) open.push_back(&inner);
  for (bool grew = true; grew;) {
    grew = std::erase_if(open, [&](const ConditionDraft* inner) {
             if (!IsReached(*inner)) return false;
             if (inner->kind == ConditionKind::kPositive) {
               Reach(EqualitySymbol(inner->id));
               Reach(EqualitySymbol(inner->value));
             }
             return true;
           }) > 0;
  }
  reached_.resize(outside);
  return open.empty();
}

void Backtracer::SortNegations() {
  reached_.clear();
  for (const Explanation::Ground& ground : out_->grounds) {
    const Wme& wme = uses_.memory.wme(ground.wme);
    for (const Symbol symbol : {wme.id, wme.value}) {
      if (symbol.IsIdentifier() && std::ranges::find(reached_, symbol) == reached_.end()) reached_.push_back(symbol);
    }
  }
  std::erase_if(out_->negations, [&](const Explanation::Negation& negation) {
    if (IsReached(negation.literal)) return false;
    out_->local_negation = true;
    if (!uses_.learn.allow_local_negations && uses_.observers.Wants(Event::kNotLearned)) {
      ConditionDraft copy = negation.literal;
      RuleDraft shown;
      shown.conditions.Add(&copy);
      const ProductionPtr rule = Production::Make(shown);
      uses_.observers.Notify(Event::kNotLearned, [&](Observer& o) { o.OnLocalNegation(uses_.agent, *rule); });
    }
    return true;
  });
}

bool Backtracer::MayReferToHigherOnly(const Condition& condition, InstantiationId firing) const {
  if (condition.kind == ConditionKind::kConjunctiveNegation) {
    return std::ranges::all_of(condition.conditions(),
                               [&](const Condition& inner) { return MayReferToHigherOnly(inner, firing); });
  }
  Symbol object = EqualitySymbol(condition.id);
  if (object.IsVariable()) {
    const Production& rule = *uses_.rete.production(uses_.instantiations[firing].production);
    object = ValueOfVariable(rule, object, uses_.instantiations.Trace(firing), uses_.memory);
  }
  return !object.IsIdentifier() || uses_.memory.level(object) < out_->level;
}

void Backtracer::CollectNegations(InstantiationId firing) {
  const Instantiation& instantiation = uses_.instantiations[firing];
  if (instantiation.production == ProductionId::kNone) {
    if (instantiation.justification == Instantiation::kNoJustification) return;
    const Justifier::Record& record = uses_.justifier.record(instantiation.justification);
    if (record.negations == nullptr) return;
    const std::span<const Condition> negations = record.negations->conditions;
    for (std::size_t n = 0; n < negations.size(); ++n) {
      const bool has_classes = n < record.negated_classes.size();
      AddNegation(
          firing, nullptr, ToDraft(negations[n], out_->drafts),
          has_classes ? std::span<const std::uint16_t>(record.negated_classes[n]) : std::span<const std::uint16_t>());
    }
    return;
  }
  if (!uses_.productions[Index(instantiation.production)].Is(ProductionRecord::kHasNegations)) return;
  const ProductionPtr& rule = uses_.rete.production(instantiation.production);
  if (rule == nullptr) return;
  for (const Condition& condition : rule->conditions) {
    if (condition.kind == ConditionKind::kPositive) continue;
    // Most negated conditions are about the substate, and their details are not needed.
    if (uses_.learn.allow_local_negations && !MayReferToHigherOnly(condition, firing)) {
      out_->local_negation = true;
      continue;
    }
    AddNegation(firing, &condition,
                InstantiateNegation(condition, *rule, uses_.instantiations.Trace(firing), uses_.memory, out_->drafts));
  }
}

void Backtracer::AddNegation(InstantiationId firing, const Condition* source, const ConditionDraft& literal,
                             std::span<const std::uint16_t> classes) {
  if (std::ranges::none_of(out_->negations,
                           [&](const Explanation::Negation& known) { return known.literal == literal; })) {
    out_->negations.push_back({firing, source, literal, classes});
  }
}

}  // namespace soarbox::kernel
