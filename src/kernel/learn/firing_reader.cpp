// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/firing_reader.h"

#include <algorithm>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/goal_changes.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/learn/draft_tests.h"
#include "kernel/learn/justification.h"
#include "kernel/match/rete.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

const FiringReader::Known& FiringReader::LookAt(ProductionId production) {
  const std::uint32_t index = Index(production);
  const ProductionPtr& rule = uses_.rete.production(production);
  if (rules_.size() <= index) rules_.resize(index + 1u);
  Known& known = rules_[index];
  known.analysis = analysis_;
  if (known.rule == rule) return known;
  known.rule = rule;
  known.positives.clear();
  known.carries_tests = false;
  known.may_test_superstate.clear();
  known.plan = rule == nullptr ? nullptr : std::make_unique<IdentityPlan>(IdentityPlan::Of(*rule));
  if (rule == nullptr) return known;
  known.positives.reserve(known.plan->of_field.size() / 3u);
  for (const Condition& condition : rule->conditions) {
    if (condition.kind != ConditionKind::kPositive) continue;
    const std::size_t number = known.positives.size();
    const Symbol attribute = EqualitySymbol(condition.attribute);
    if (!attribute.IsConstant() || attribute == words::kSuperstate) {
      known.may_test_superstate.push_back(static_cast<std::uint16_t>(number));
    }
    Tested& tested = known.positives.emplace_back();
    tested.condition = &condition;
    std::uint8_t field = 1;
    for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) {
      ForEachTest(*test, [&](const Test& part) {
        if (IsCarried(part.kind)) tested.carried |= field;
      });
      field = static_cast<std::uint8_t>(field << 1);
    }
    known.carries_tests = known.carries_tests || tested.carried != 0;
  }
  return known;
}

FiringReader::Term FiringReader::TermOf(const RhsValue& value, const IdentityPlan& plan) {
  Term term;
  switch (value.kind) {
    case RhsValueKind::kConstant:
      break;
    case RhsValueKind::kBound:
    case RhsValueKind::kNew:
      if (const std::uint16_t bound = ClassOf(value, plan); bound != IdentityPlan::kLiteral) {
        term.kind = Term::Kind::kClass;
        term.identity_class = bound;
      }
      break;
    case RhsValueKind::kFunction:
      term.kind = Term::Kind::kFunction;
      term.function = &value;
      break;
  }
  return term;
}

const RhsValue* FiringReader::WrittenBy(const Preference& preference, Part part) {
  const Production* const rule = Rule(preference.instantiation);
  if (rule == nullptr || preference.action >= rule->actions.size()) return nullptr;
  const Action& action = rule->actions[preference.action];
  const RhsValue* const parts[] = {&action.id, &action.attribute, &action.value, &action.referent};
  return parts[static_cast<std::size_t>(part)];
}

const Production* FiringReader::Rule(InstantiationId firing) {
  const ProductionId production = uses_.instantiations[firing].production;
  return production == ProductionId::kNone ? nullptr : KnownOf(production).rule.get();
}

const FiringReader::Tested& FiringReader::TestedBy(InstantiationId firing, std::size_t condition) {
  static const Tested kCopied;
  const Known& known = KnownOf(uses_.instantiations[firing].production);
  return condition < known.positives.size() ? known.positives[condition] : kCopied;
}

bool FiringReader::CarriesTests(InstantiationId firing) {
  const Instantiation& instantiation = uses_.instantiations[firing];
  if (instantiation.production != ProductionId::kNone) return KnownOf(instantiation.production).carries_tests;
  return instantiation.justification != Instantiation::kNoJustification &&
         !uses_.justifier.record(instantiation.justification).tests.empty();
}

const IdentityPlan& FiringReader::UncommonPlan(InstantiationId firing) {
  const Instantiation& instantiation = uses_.instantiations[firing];
  if (instantiation.justification != Instantiation::kNoJustification) {
    return *uses_.justifier.record(instantiation.justification).plan;
  }
  for (const auto& [known, plan] : without_rule_) {
    if (known == firing) return *plan;
  }
  without_rule_.emplace_back(firing, std::make_unique<IdentityPlan>(instantiation.copied ? PlanWithCopied(firing)
                                                                                         : PlanOfArchitecture(firing)));
  return *without_rule_.back().second;
}

/// Each identifier forms one class in all its fields; constants have no class.
IdentityPlan FiringReader::PlanOfArchitecture(InstantiationId firing) const {
  IdentityPlan plan;
  for (const ConditionTrace& trace : uses_.instantiations.Trace(firing)) {
    const Wme& wme = uses_.memory.wme(trace.wme);
    for (const Symbol symbol : {wme.id, wme.attribute, wme.value}) {
      if (symbol.IsIdentifier()) {
        plan.AddField(symbol);
      } else {
        plan.of_field.push_back(IdentityPlan::kLiteral);
      }
    }
  }
  return plan;
}

IdentityPlan FiringReader::PlanWithCopied(InstantiationId firing) {
  IdentityPlan plan = *KnownOf(uses_.instantiations[firing].production).plan;
  std::unordered_map<std::uint32_t, std::uint16_t> class_of;
  for (std::uint16_t known = plan.bound(); known-- > 0;) {
    const Symbol value = ValueOfClass(plan, known, uses_.instantiations.Trace(firing), uses_.memory);
    if (value.IsIdentifier()) class_of[value.bits()] = known;
  }
  const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(firing);
  for (std::size_t n = plan.of_field.size() / 3u; n < traces.size(); ++n) {
    const Wme& wme = uses_.memory.wme(traces[n].wme);
    for (const Symbol symbol : {wme.id, wme.attribute, wme.value}) {
      std::uint16_t known = IdentityPlan::kLiteral;
      if (symbol.IsIdentifier()) {
        const auto [found, is_new] = class_of.try_emplace(symbol.bits(), plan.bound());
        known = found->second;
        if (is_new) {
          plan.first.push_back(static_cast<std::uint16_t>(plan.of_field.size()));
          plan.variables.push_back(symbol);
        }
      }
      plan.of_field.push_back(known);
    }
  }
  return plan;
}

FiringReader::Term FiringReader::TermOfCopier(const Preference& preference, Part part) {
  const Instantiation& instantiation = uses_.instantiations[preference.instantiation];
  const IdentityPlan& plan = Plan(preference.instantiation);
  const Symbol symbols[] = {preference.id, preference.attribute, preference.value, preference.referent};
  const Symbol symbol = symbols[static_cast<std::size_t>(part)];
  Term term;
  if (symbol.IsIdentifier()) {
    for (const auto& [copy, original] : copied_[instantiation.serial]) {
      if (copy != symbol) continue;
      for (std::uint16_t known = 0; known < plan.bound(); ++known) {
        if (ValueOfClass(plan, known, uses_.instantiations.Trace(preference.instantiation), uses_.memory) != original)
          continue;
        term.kind = Term::Kind::kClass;
        term.identity_class = known;
        return term;
      }
      break;
    }
  }
  if (const RhsValue* const written = WrittenBy(preference, part)) return TermOf(*written, plan);
  if (symbol.IsIdentifier()) {
    term.kind = Term::Kind::kSymbol;
    term.symbol = symbol;
  }
  return term;
}

void FiringReader::NoteCopied(InstantiationId firing, std::span<const RuleContext::Copied> copied) {
  Instantiation& instantiation = uses_.instantiations[firing];
  instantiation.copied = true;
  std::vector<std::pair<Symbol, Symbol>>& known = copied_[instantiation.serial];
  for (const RuleContext::Copied& element : copied) {
    const std::pair<Symbol, Symbol> pair(element.copy, element.original);
    if (known.empty() || known.back() != pair) known.push_back(pair);
  }
}

void FiringReader::ForgetCopied(InstantiationId firing) {
  copied_.erase(uses_.instantiations[firing].serial);
}

void FiringReader::NoteTurned(InstantiationId firing, const std::vector<TurnedTest>& tests) {
  if (tests.empty()) return;
  uses_.instantiations[firing].turned = true;
  turned_[uses_.instantiations[firing].serial] = tests;
}

void FiringReader::ForgetTurned(InstantiationId firing) {
  turned_.erase(uses_.instantiations[firing].serial);
}

bool FiringReader::IsTurned(InstantiationId firing, std::uint16_t condition, Field field, const Test& test) const {
  const Instantiation& instantiation = uses_.instantiations[firing];
  if (!instantiation.turned) return false;
  const auto found = turned_.find(instantiation.serial);
  return found != turned_.end() && std::ranges::any_of(found->second, [&](const TurnedTest& turned) {
           return turned.condition == condition && turned.field == field && turned.kind == test.kind &&
                  turned.referent == test.referent();
         });
}

std::uint16_t FiringReader::ClassOf(const RhsValue& value, const IdentityPlan& plan) {
  if (value.kind == RhsValueKind::kNew) return static_cast<std::uint16_t>(plan.bound() + value.new_index());
  return plan.ClassOf(value.site().positive_condition, value.site().field);
}

FiringReader::Term FiringReader::TermOf(PreferenceId preference_id, Part part) {
  const Preference& preference = uses_.memory.preference(preference_id);
  const Instantiation& instantiation = uses_.instantiations[preference.instantiation];
  if (instantiation.copied && instantiation.has_identities) [[unlikely]]
    return TermOfCopier(preference, part);
  if (instantiation.has_identities) {
    if (const RhsValue* const written = WrittenBy(preference, part)) {
      return TermOf(*written, *KnownOf(instantiation.production).plan);
    }
  }
  return UncommonTermOf(preference, part);
}

FiringReader::Term FiringReader::UncommonTermOf(const Preference& preference, Part part) {
  const InstantiationId firing = preference.instantiation;
  const Instantiation& instantiation = uses_.instantiations[firing];
  Term term;
  if (!instantiation.has_identities) {
    term.kind = Term::Kind::kUnknown;
    return term;
  }
  const Symbol symbols[] = {preference.id, preference.attribute, preference.value, preference.referent};
  const Symbol symbol = symbols[static_cast<std::size_t>(part)];
  const bool is_rule = Rule(firing) != nullptr;
  const bool is_justification = !is_rule && instantiation.justification != Instantiation::kNoJustification;
  if (!is_justification && !symbol.IsIdentifier()) return term;
  if (!is_rule) {
    term.identity_class = is_justification
                              ? Plan(firing).of_action[4u * preference.action + static_cast<std::size_t>(part)]
                              : Plan(firing).ClassOf(symbol);
    if (term.identity_class != IdentityPlan::kLiteral) {
      term.kind = Term::Kind::kClass;
      return term;
    }
    term.identity_class = 0;
    if (is_justification) {
      const ProductionPtr& functions = uses_.justifier.record(instantiation.justification).functions;
      if (functions != nullptr && preference.action < functions->actions.size()) {
        const Action& action = functions->actions[preference.action];
        const RhsValue& value = part == Part::kAttribute ? action.attribute : action.value;
        if ((part == Part::kAttribute || part == Part::kValue) && value.kind == RhsValueKind::kFunction) {
          term.kind = Term::Kind::kFunction;
          term.function = &value;
        }
      }
      return term;
    }
  }
  // Created by the architecture or by a function.
  term.kind = Term::Kind::kSymbol;
  term.symbol = symbol;
  return term;
}

std::uint32_t FiringReader::RankOfNew(InstantiationId firing, std::uint16_t new_index) {
  const Production* const rule = Rule(firing);
  std::vector<std::uint16_t> seen;
  for (std::size_t n = rule == nullptr ? 0 : rule->actions.size(); n-- > 0;) {
    const Action& action = rule->actions[n];
    for (const RhsValue* value : {&action.id, &action.attribute, &action.value, &action.referent}) {
      if (value->kind != RhsValueKind::kNew) continue;
      if (std::ranges::find(seen, value->new_index()) != seen.end()) continue;
      if (value->new_index() == new_index) return static_cast<std::uint32_t>(seen.size());
      seen.push_back(value->new_index());
    }
  }
  return new_index;
}

bool FiringReader::IsSuperstateLink(WmeId id, GoalLevel level) const {
  const Wme& wme = uses_.memory.wme(id);
  return wme.attribute == words::kSuperstate && level <= uses_.goals.depth() && wme.id == uses_.goals.at(level).id &&
         uses_.memory.record(id).kind == WmeKind::kArchitecture;
}

bool FiringReader::IsOfSuperstateLink(InstantiationId firing, std::uint16_t identity_class, IdentityGraph::Key& key) {
  const Instantiation& instantiation = uses_.instantiations[firing];
  const GoalLevel level = instantiation.level;
  if (level < 2 || level > uses_.goals.depth() || !uses_.goals.at(level).has_identities) return false;
  const IdentityPlan& plan = Plan(firing);
  const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(firing);
  const auto is_it = [&](std::size_t condition) {
    for (const Part part : {Part::kId, Part::kValue}) {
      if (plan.ClassOf(condition, static_cast<Field>(part)) != identity_class) continue;
      if (!IsSuperstateLink(traces[condition].wme, level)) return false;
      key = SuperstateLink(level, part);
      return true;
    }
    return false;
  };
  if (instantiation.production != ProductionId::kNone) {
    return std::ranges::any_of(KnownOf(instantiation.production).may_test_superstate, is_it);
  }
  for (std::size_t n = 0; n < traces.size(); ++n) {
    if (is_it(n)) return true;
  }
  return false;
}

std::uint32_t FiringReader::CountIdentities(InstantiationId firing) {
  return static_cast<std::uint32_t>(std::ranges::count_if(
      Plan(firing).first, [&](std::uint16_t place) { return SourceOf(firing, place) == Source::kOwn; }));
}

FiringReader::Source FiringReader::SourceOf(InstantiationId firing, std::uint16_t place) {
  const ConditionTrace& trace = uses_.instantiations.Trace(firing)[place / 3u];
  const Part part = static_cast<Part>(place % 3u);
  if (trace.preference != PreferenceId::kNone) {
    if (!trace.inherits) return Source::kOwn;
    const Term::Kind kind = TermOf(trace.preference, part).kind;
    return kind == Term::Kind::kClass || kind == Term::Kind::kSymbol ? Source::kMaker : Source::kOwn;
  }
  const GoalLevel level = uses_.instantiations[firing].level;
  if (level < 2 || part == Part::kAttribute || level > uses_.goals.depth() || !uses_.goals.at(level).has_identities) {
    return Source::kOwn;
  }
  if (IsSuperstateLink(trace.wme, level)) return Source::kSuperstate;
  const Wme& wme = uses_.memory.wme(trace.wme);
  if (wme.id == uses_.goals.at(level).id && uses_.goal_changes.ProposalOfItem(trace.wme) != WmeId::kNone) {
    return Source::kItem;
  }
  return Source::kOwn;
}

IdentityGraph::Key FiringReader::Origin(InstantiationId& firing, std::uint16_t identity_class) {
  for (;;) {
    const Instantiation& instantiation = uses_.instantiations[firing];
    const IdentityGraph::Key own{instantiation.serial, identity_class};
    const IdentityPlan& plan = Plan(firing);
    if (identity_class >= plan.bound()) return own;
    if (IdentityGraph::Key link; IsOfSuperstateLink(firing, identity_class, link)) return link;
    const std::uint16_t place = plan.first[identity_class];
    const ConditionTrace& trace = uses_.instantiations.Trace(firing)[place / 3u];
    const Part part = static_cast<Part>(place % 3u);
    if (trace.preference != PreferenceId::kNone) {
      if (!trace.inherits) return own;
      const Term term = TermOf(trace.preference, part);
      if (term.kind == Term::Kind::kSymbol) return OfSymbol(term.symbol);
      if (term.kind != Term::Kind::kClass) return own;
      firing = uses_.memory.preference(trace.preference).instantiation;
      identity_class = term.identity_class;
      continue;
    }
    switch (SourceOf(firing, place)) {
      case Source::kSuperstate:
        return SuperstateLink(instantiation.level, part);
      case Source::kItem:
        return part == Part::kId ? SuperstateLink(instantiation.level, part) : Item(trace.wme);
      case Source::kOwn:
      case Source::kMaker:
        return own;
    }
  }
}

void FiringReader::Clear() {
  copied_.clear();
  turned_.clear();
  without_rule_.clear();
}

}  // namespace soarbox::kernel
