// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/firing_reader.h"

#include "kernel/base/words.h"
#include "kernel/decide/engine.h"

namespace soarbox::kernel {

const Production* FiringReader::Rule(InstantiationId firing) const {
  const ProductionId rule = engine_.instantiations[firing].production;
  return rule == ProductionId::kNone ? nullptr : engine_.rete.production(rule).get();
}

const IdentityPlan& FiringReader::Plan(InstantiationId firing) {
  const Instantiation& instantiation = engine_.instantiations[firing];
  if (instantiation.production != ProductionId::kNone) {
    const std::uint32_t index = Index(instantiation.production);
    const ProductionPtr& rule = engine_.rete.production(instantiation.production);
    if (plans_.size() <= index) plans_.resize(index + 1u);
    Known& known = plans_[index];
    if (known.rule != rule) {
      known.rule = rule;
      known.plan = std::make_unique<IdentityPlan>(IdentityPlan::Of(*rule));
    }
    return *known.plan;
  }
  if (instantiation.justification != Instantiation::kNoJustification) {
    return *engine_.justifier.record(instantiation.justification).plan;
  }
  for (const auto& [known, plan] : without_rule_) {
    if (known == firing) return *plan;
  }
  without_rule_.emplace_back(firing, std::make_unique<IdentityPlan>(PlanOfArchitecture(firing)));
  return *without_rule_.back().second;
}

/// Identifiers are what they are in each place; constants stand for themselves.
IdentityPlan FiringReader::PlanOfArchitecture(InstantiationId firing) const {
  IdentityPlan plan;
  for (const ConditionTrace& trace : engine_.instantiations.Trace(firing)) {
    const Wme& wme = engine_.memory.wme(trace.wme);
    for (const Symbol symbol : {wme.id, wme.attribute, wme.value}) {
      std::uint16_t known = IdentityPlan::kLiteral;
      if (symbol.IsIdentifier()) {
        known = plan.ClassOf(symbol);
        if (known == IdentityPlan::kLiteral) {
          known = plan.bound();
          plan.first.push_back(static_cast<std::uint16_t>(plan.of_field.size()));
          plan.variables.push_back(symbol);
        }
      }
      plan.of_field.push_back(known);
    }
  }
  return plan;
}

std::uint16_t FiringReader::ClassOf(const RhsValue& value, InstantiationId firing) {
  const IdentityPlan& plan = Plan(firing);
  if (value.kind == RhsValueKind::kNew) return static_cast<std::uint16_t>(plan.bound() + value.new_index());
  return plan.ClassOf(value.site().positive_condition, value.site().field);
}

FiringReader::Term FiringReader::TermOf(PreferenceId preference_id, Part part) {
  const Preference& preference = engine_.memory.preference(preference_id);
  const InstantiationId firing = preference.instantiation;
  const Instantiation& instantiation = engine_.instantiations[firing];
  Term term;
  const auto by_class = [&](std::uint16_t identity_class) {
    if (identity_class == IdentityPlan::kLiteral) return;
    term.kind = Term::Kind::kClass;
    term.identity_class = identity_class;
  };
  if (!instantiation.has_identities) {
    term.kind = Term::Kind::kUnknown;
    return term;
  }
  const Symbol symbols[] = {preference.id, preference.attribute, preference.value, preference.referent};
  const Symbol symbol = symbols[static_cast<std::size_t>(part)];
  const Production* const rule = Rule(firing);
  if (rule == nullptr && instantiation.justification != Instantiation::kNoJustification) {
    by_class(Plan(firing).of_action[4u * preference.action + static_cast<std::size_t>(part)]);
    return term;
  }
  if (rule == nullptr || preference.action >= rule->actions.size()) {
    // Of the architecture, or made by a function.
    if (!symbol.IsIdentifier()) return term;
    if (rule == nullptr) by_class(Plan(firing).ClassOf(symbol));
    if (term.kind == Term::Kind::kClass) return term;
    term.kind = Term::Kind::kSymbol;
    term.symbol = symbol;
    return term;
  }
  const Action& action = rule->actions[preference.action];
  const RhsValue* const values[] = {&action.id, &action.attribute, &action.value, &action.referent};
  const RhsValue& value = *values[static_cast<std::size_t>(part)];
  switch (value.kind) {
    case RhsValueKind::kConstant:
      break;
    case RhsValueKind::kBound:
    case RhsValueKind::kNew:
      by_class(ClassOf(value, firing));
      break;
    case RhsValueKind::kFunction:
      term.kind = Term::Kind::kFunction;
      term.function = &value;
      break;
  }
  return term;
}

bool FiringReader::IsSuperstateLink(WmeId id, GoalLevel level) const {
  const Wme& wme = engine_.memory.wme(id);
  return wme.attribute == words::kSuperstate && level <= engine_.goals.depth() &&
         wme.id == engine_.goals.at(level).id && engine_.memory.record(id).kind == WmeKind::kArchitecture;
}

FiringReader::Source FiringReader::SourceOf(InstantiationId firing, std::uint16_t place) {
  const ConditionTrace& trace = engine_.instantiations.Trace(firing)[place / 3u];
  const Part part = static_cast<Part>(place % 3u);
  if (trace.preference != PreferenceId::kNone) {
    if (!trace.inherits) return Source::kOwn;
    const Term::Kind kind = TermOf(trace.preference, part).kind;
    return kind == Term::Kind::kClass || kind == Term::Kind::kSymbol ? Source::kMaker : Source::kOwn;
  }
  const GoalLevel level = engine_.instantiations[firing].level;
  if (level < 2 || part == Part::kAttribute || level > engine_.goals.depth() ||
      !engine_.goals.at(level).has_identities) {
    return Source::kOwn;
  }
  if (IsSuperstateLink(trace.wme, level)) return Source::kSuperstate;
  const Wme& wme = engine_.memory.wme(trace.wme);
  if (wme.id == engine_.goals.at(level).id && engine_.goal_changes.ProposalOfItem(trace.wme) != WmeId::kNone) {
    return Source::kItem;
  }
  if (wme.id == engine_.goals.at(level).id && part == Part::kValue && !wme.value.IsIdentifier()) {
    return Source::kArchitecture;
  }
  return Source::kOwn;
}

IdentityGraph::Key FiringReader::Origin(InstantiationId& firing, std::uint16_t identity_class) {
  for (;;) {
    const IdentityGraph::Key own{engine_.instantiations[firing].serial, identity_class};
    const IdentityPlan& plan = Plan(firing);
    if (identity_class >= plan.bound()) return own;
    const std::uint16_t place = plan.first[identity_class];
    const ConditionTrace& trace = engine_.instantiations.Trace(firing)[place / 3u];
    const Part part = static_cast<Part>(place % 3u);
    switch (SourceOf(firing, place)) {
      case Source::kOwn:
      case Source::kArchitecture:
        return own;
      case Source::kSuperstate:
        return SuperstateLink(engine_.instantiations[firing].level, part);
      case Source::kItem:
        return part == Part::kId ? SuperstateLink(engine_.instantiations[firing].level, part) : Item(trace.wme);
      case Source::kMaker: {
        const Term term = TermOf(trace.preference, part);
        if (term.kind == Term::Kind::kSymbol) return OfSymbol(term.symbol);
        firing = engine_.memory.preference(trace.preference).instantiation;
        identity_class = term.identity_class;
        break;
      }
    }
  }
}

void FiringReader::Clear() {
  without_rule_.clear();
}

}  // namespace soarbox::kernel
