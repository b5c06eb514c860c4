// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/rule_info.h"

#include <algorithm>
#include <functional>

#include "kernel/base/known_symbols.h"
#include "kernel/rules/draft.h"

namespace soarbox::kernel {

namespace {

bool MayTestSelectedOperator(const Condition& condition) {
  if (condition.tests_acceptable) {
    return false;
  }
  const Symbol attribute = EqualitySymbol(condition.attribute);
  return !attribute || attribute.IsVariable() || attribute == words::kOperator;
}

Symbol SymbolAt(const BindingSite& site, std::span<const WmeId> elements, const WmeTable& wmes) {
  if (site.positive_condition >= elements.size()) {
    return Symbol();
  }
  const Wme& wme = wmes[Index(elements[site.positive_condition])];
  return site.field == Field::kId ? wme.id : site.field == Field::kAttribute ? wme.attribute : wme.value;
}

bool SameValue(const RhsValue& a, const RhsValue& b) {
  if (a.kind != b.kind) {
    return false;
  }
  switch (a.kind) {
    case RhsValueKind::kConstant:
      return a.symbol() == b.symbol();
    case RhsValueKind::kBound:
      return a.site() == b.site();
    case RhsValueKind::kNew:
      return a.new_index() == b.new_index();
    case RhsValueKind::kFunction:
      break;
  }
  // As in Soar, two calls are equal if one of them only lacks some of the last arguments.
  const std::size_t both = std::min(a.arguments().size(), b.arguments().size());
  return a.function_index() == b.function_index() &&
         std::ranges::equal(a.arguments().first(both), b.arguments().first(both), SameValue);
}

void MixInto(std::uint32_t& hash, std::uint32_t value) {
  hash = (hash ^ value) * 0x85EBCA6Bu;
  hash ^= hash >> 15;
}

void MixValue(std::uint32_t& hash, const RhsValue& value) {
  MixInto(hash, static_cast<std::uint32_t>(value.kind));
  switch (value.kind) {
    case RhsValueKind::kConstant:
      MixInto(hash, value.symbol().bits());
      break;
    case RhsValueKind::kBound:
      MixInto(hash, value.site().positive_condition * 4u + static_cast<std::uint32_t>(value.site().field));
      break;
    case RhsValueKind::kNew:
      MixInto(hash, value.new_index());
      break;
    case RhsValueKind::kFunction:
      MixInto(hash, value.function_index());
      break;
  }
}

}  // namespace

RuleInfo::RuleInfo(ProductionPtr production) : rule(std::move(production)) {
  const std::size_t conditions = rule->conditions.size();
  Arena arena;
  Symbol* const ids = arena.NewArray<Symbol>(conditions);  // The identifier variables found so far.
  std::uint16_t* const new_ids = arena.NewArray<std::uint16_t>(conditions);
  std::uint16_t* const operators = arena.NewArray<std::uint16_t>(conditions);
  BindingSite* const proposals = arena.NewArray<BindingSite>(rule->actions.size());
  BindingSite* const changed = arena.NewArray<BindingSite>(rule->actions.size());
  std::size_t new_id_count = 0, operator_count = 0, proposal_count = 0, changed_count = 0;
  for (const Condition& condition : rule->conditions) {
    if (condition.kind != ConditionKind::kPositive) {
      continue;
    }
    const Symbol id = EqualitySymbol(condition.id);
    if (!id || std::find(ids, ids + new_id_count, id) == ids + new_id_count) {
      ids[new_id_count] = id;
      new_ids[new_id_count++] = positives;
    }
    if (MayTestSelectedOperator(condition)) {
      operators[operator_count++] = positives;
    }
    ++positives;
  }
  const bool by_match = operator_count != 0 && rule->declared_support == DeclaredSupport::kUndeclared;
  for (const Action& action : rule->actions) {
    if (by_match && !action.is_function_call) {
      if (action.id.kind != RhsValueKind::kBound) {
        has_other_action_ids = true;
      } else if (std::find(changed, changed + changed_count, action.id.site()) == changed + changed_count) {
        changed[changed_count++] = action.id.site();
      }
    }
    if (!action.is_function_call && action.preference == PreferenceType::kAcceptable &&
        action.attribute.kind == RhsValueKind::kConstant && action.attribute.symbol() == words::kOperator &&
        action.id.kind == RhsValueKind::kBound) {
      proposals[proposal_count++] = action.id.site();
    }
  }
  static_assert(sizeof(BindingSite) == 2 * sizeof(std::uint16_t) && alignof(BindingSite) == alignof(std::uint16_t));
  lists_ = std::make_unique_for_overwrite<std::uint16_t[]>(new_id_count + operator_count +
                                                           2 * (proposal_count + changed_count));
  std::uint16_t* const operator_list = std::copy_n(new_ids, new_id_count, lists_.get());
  std::uint16_t* const proposal_list = std::copy_n(operators, operator_count, operator_list);
  std::uint16_t* const changed_list = proposal_list + 2 * proposal_count;
  std::uninitialized_copy_n(proposals, proposal_count, reinterpret_cast<BindingSite*>(proposal_list));
  std::uninitialized_copy_n(changed, changed_count, reinterpret_cast<BindingSite*>(changed_list));
  id_conditions = {lists_.get(), new_id_count};
  operator_conditions = {operator_list, operator_count};
  proposal_ids = {reinterpret_cast<const BindingSite*>(proposal_list), proposal_count};
  action_ids = {reinterpret_cast<const BindingSite*>(changed_list), changed_count};
  if (rule->declared_support != DeclaredSupport::kUndeclared) {
    support = rule->declared_support == DeclaredSupport::kOSupport ? Support::kO : Support::kI;
  } else {
    support = operator_conditions.empty() ? Support::kI : Support::kByMatch;
  }
}

bool RuleInfo::Proposes(std::span<const WmeId> elements, const WmeTable& wmes,
                        std::span<const GoalLevel> level_of_goal) const {
  for (const BindingSite& site : proposal_ids) {
    const Symbol id = SymbolAt(site, elements, wmes);
    if (id.IsIdentifier() && id.index() < level_of_goal.size() && level_of_goal[id.index()] != 0) {
      return true;
    }
  }
  return false;
}

RuleInfo::OperatorUse RuleInfo::UseOfOperator(std::span<const WmeId> tested, Symbol goal, std::span<const WmeId> actor,
                                              const WmeTable& wmes) const {
  OperatorUse use;
  bool several = false;
  for (const std::uint16_t condition : operator_conditions) {
    const Wme& wme = wmes[Index(tested[condition])];
    if (wme.id != goal || wme.attribute != words::kOperator || wme.acceptable) {
      continue;
    }
    several |= use.selected && use.selected != wme.value;
    use.selected = wme.value;
    use.applies |= has_other_action_ids;
    for (const BindingSite& site : action_ids) {
      (SymbolAt(site, actor, wmes) == wme.value ? use.elaborates : use.applies) = true;
    }
  }
  if (several) {
    use.selected = Symbol();
  }
  return use;
}

namespace {

/// Templates are not RL rules, but are compared like them.
bool HasLearnedNumber(const Production& rule) {
  return rule.is_rl || (rule.type == ProductionType::kTemplate && rule.actions.size() == 1 &&
                        rule.actions.front().preference == PreferenceType::kNumericIndifferent);
}

}  // namespace

bool SameActions(const Production& a, const Production& b, bool ignore_rl_value) {
  const auto is_number = [](const RhsValue& value) {
    return value.kind == RhsValueKind::kConstant && value.symbol().IsNumber();
  };
  const std::size_t both = std::min(a.actions.size(), b.actions.size());
  for (std::size_t n = 0; n < both; ++n) {
    const Action& x = a.actions[n];
    const Action& y = b.actions[n];
    if (x.is_function_call != y.is_function_call) {
      return false;
    }
    if (x.is_function_call) {
      return SameValue(x.value, y.value);
    }
    if (x.preference != y.preference || !SameValue(x.id, y.id) || !SameValue(x.attribute, y.attribute) ||
        !SameValue(x.value, y.value)) {
      return false;
    }
    const bool skip_referent =
        ignore_rl_value && HasLearnedNumber(a) && HasLearnedNumber(b) && is_number(x.referent) && is_number(y.referent);
    if (x.HasReferent() && !skip_referent && !SameValue(x.referent, y.referent)) {
      return false;
    }
  }
  return a.actions.size() == b.actions.size();
}

std::uint32_t ActionsDigest(const Production& production) {
  std::uint32_t hash = 0x9E3779B1u;
  for (const Action& action : production.actions) {
    MixInto(hash, action.is_function_call ? 99u : static_cast<std::uint32_t>(action.preference));
    MixValue(hash, action.value);
    if (action.is_function_call) {
      break;
    }
    MixValue(hash, action.id);
    MixValue(hash, action.attribute);
    if (action.HasReferent() && !HasLearnedNumber(production)) {
      MixValue(hash, action.referent);
    }
  }
  return hash;
}

}  // namespace soarbox::kernel
