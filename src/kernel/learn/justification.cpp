// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/justification.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/agent_settings.h"
#include "kernel/decide/descriptions.h"
#include "kernel/decide/firing.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/decide/rule_changes.h"
#include "kernel/learn/chunker.h"
#include "kernel/learn/draft_tests.h"
#include "kernel/match/rete.h"
#include "kernel/memory/wme_changes.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {
namespace {

std::string NameOfNumber(std::uint32_t number) {
  return "justify" + std::to_string(number);
}

ValueDraft Constant(Symbol symbol) {
  ValueDraft value;
  value.symbol = symbol;
  return value;
}

}  // namespace

// Support -------------------------------------------------------------------------------------------------------------

/// Whether the actions of the rule that fired as `base` propose an operator for a state. As in Soar 9.6.3, false for
/// rules whose last condition is negated.
bool Justifier::Proposes(InstantiationId base) const {
  const WorkingMemory& memory = uses_.memory;
  const Instantiation& instantiation = uses_.instantiations[base];
  if (instantiation.justification != Instantiation::kNoJustification) {
    const Record& record = records_[instantiation.justification];
    return instantiation.match != MatchId::kNone && record.negations == nullptr &&
           std::ranges::any_of(record.results, [&](const Record::Result& result) {
             return result.type == PreferenceType::kAcceptable && result.attribute == words::kOperator &&
                    memory.identifier(result.id).is_goal;
           });
  }
  if (instantiation.production == ProductionId::kNone) return false;
  const Production& rule = *uses_.rete.production(instantiation.production);
  if (rule.conditions.empty() || rule.conditions.back().kind != ConditionKind::kPositive) return false;
  const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(base);
  return std::ranges::any_of(rule.actions, [&](const Action& action) {
    if (action.is_function_call || action.preference != PreferenceType::kAcceptable ||
        action.attribute.kind != RhsValueKind::kConstant || action.attribute.symbol() != words::kOperator ||
        action.id.kind != RhsValueKind::kBound) {
      return false;
    }
    const BindingSite site = action.id.site();
    return memory.identifier(FieldOf(memory.wme(traces[site.positive_condition].wme), site.field)).is_goal;
  });
}

bool Justifier::IsOSupported(const Explanation& explanation, InstantiationId made, GoalLevel goal_level) {
  const WorkingMemory& memory = uses_.memory;
  if (explanation.operator_grounds.empty() || Proposes(explanation.base)) return false;
  const Symbol goal = uses_.goals.at(goal_level).id;
  bool elaborates = false, applies = false;
  for (const WmeId ground : explanation.operator_grounds) {
    if (memory.wme(ground).id != goal) continue;
    for (const PreferenceId result : explanation.results) {
      (memory.preference(result).id == memory.wme(ground).value ? elaborates : applies) = true;
    }
  }
  if (!elaborates || !applies || !uses_.settings.warn_of_mixed_support) return applies;
  uses_.observers.Print(
      "\nWARNING:  Operator elaborations mixed with operator applications\nAssigning i_support to prod " +
      std::string(uses_.descriptions.ProductionName(made)));
  return false;
}

std::uint32_t Justifier::NewRecord() {
  std::uint32_t index;
  if (!free_records_.empty()) {
    index = free_records_.back();
    free_records_.pop_back();
  } else {
    index = static_cast<std::uint32_t>(records_.size());
    records_.emplace_back();
  }
  Record& record = records_[index];
  record.live = true;
  record.excised = false;
  record.production = ProductionId::kNone;
  record.name.clear();
  record.plan.reset();
  if (index < names_.size()) names_[index].clear();
  return index;
}

// Creating justifications ---------------------------------------------------------------------------------------------

InstantiationId Justifier::Build(const Explanation& explanation, GoalLevel goal_level, Making making) {
  const std::uint32_t digest = Digest(explanation);
  std::uint32_t original = OriginalOf(explanation, digest);
  if (original != Instantiation::kNoJustification && uses_.settings.like != SoarVersion::k963 &&
      uses_.instantiations[records_[original].instantiation].o_support) {
    // Its results may have been removed since, although it still matches: the new justification creates them again.
    Excise(original);
    CountDuplicate(explanation.base);
    original = Instantiation::kNoJustification;
  }
  const std::uint32_t number = making.name.empty() ? TakeNumber() : 0;
  if (uses_.observers.Wants(Event::kLearning)) {
    const std::string name = making.name.empty() ? NameOfNumber(number) : making.name;
    uses_.observers.Notify(Event::kLearning, [&](Observer& o) {
      o.OnLearning(uses_.agent, name);
      if (original != Instantiation::kNoJustification) o.OnDuplicateLearned(uses_.agent, name, Name(original));
    });
  }
  if (original != Instantiation::kNoJustification) {
    uses_.instantiations.SkipSerials(1);
    CountDuplicate(explanation.base);
    // Unused results are freed together with the discarded justification: these firings leave no preferences.
    for (const PreferenceId result : explanation.results) uses_.preferences.FreeIfUnused(result);
    return InstantiationId::kNone;
  }
  const std::uint32_t index = NewRecord();
  const InstantiationId id = uses_.instantiations.Make();
  {
    Instantiation& instantiation = uses_.instantiations[id];
    instantiation.goal = uses_.goals.at(goal_level).id;
    instantiation.level = goal_level;
    instantiation.held = true;
    instantiation.justification = index;
    instantiation.has_identities = making.plan != nullptr;
    instantiation.local_negation = explanation.local_negation;
    instantiation.long_term_memory = explanation.long_term_memory;
  }
  Record& record = records_[index];
  record.number = number;
  record.order = next_order_++;
  record.name = std::move(making.name);
  record.base = std::move(making.origin.base);
  record.depth = making.origin.depth + 1;
  record.plan = std::move(making.plan);
  record.tests = std::move(making.tests);
  record.functions = std::move(making.functions);
  record.negated_classes = std::move(making.negated_classes);
  record.quiescence = explanation.quiescence;
  record.instantiation = id;
  record.grounds.clear();
  for (const Explanation::Ground& ground : explanation.grounds) {
    record.grounds.push_back(ground.wme);
    uses_.changes.AddReference(ground.wme);
  }
  if (!explanation.negations.empty()) {
    RuleDraft kept;
    std::vector<ConditionDraft> copies;
    for (const Explanation::Negation& negation : explanation.negations) copies.push_back(negation.literal);
    for (ConditionDraft& copy : copies) kept.conditions.Add(&copy);
    record.negations = Production::Make(kept);
  }
  record.results.clear();
  for (const PreferenceId result : explanation.results) record.results.push_back(ResultOf(result));
  record.digest = digest;
  NoteAlike(index);
  ++uses_.counters.justifications;
  if (goal_level > 1) {
    uses_.firing.TraceConditions(id, record.grounds);
    if (record.plan != nullptr) uses_.chunker.NoteFiring(id);
  }

  if (uses_.observers.Wants(Event::kLearning)) {
    const FiringInfo info = uses_.descriptions.DescribeInstantiation(id);
    uses_.observers.Notify(Event::kLearning, [&](Observer& o) { o.OnLearned(uses_.agent, info); });
  }
  const bool o_support = IsOSupported(explanation, id, goal_level);
  MakeClones(explanation, id, {}, o_support);
  uses_.instantiations[id].o_support = o_support;
  uses_.instantiations[id].match = MatchOf(index, id, goal_level);
  uses_.preferences.LinkToGoal(id);
  uses_.firing.made().push_back(id);
  return id;
}

/// Creates clones of the results at the goal level of `holder`. The list is newest first, so the last result is cloned
/// first.
void Justifier::MakeClones(const Explanation& explanation, InstantiationId holder,
                           std::span<const std::uint16_t> actions, bool o_support) {
  WorkingMemory& memory = uses_.memory;
  for (std::size_t n = explanation.results.size(); n-- > 0;) {
    const PreferenceId result = explanation.results[n];
    const Preference& original = memory.preference(result);
    const PreferenceId clone = uses_.preferences.Make(holder, original.id, original.attribute, original.value,
                                                      original.referent, original.type, o_support);
    Preference& made = memory.mutable_preference(clone);
    Preference& source = memory.mutable_preference(result);
    made.action = actions.empty() ? static_cast<std::uint16_t>(n) : actions[n];
    made.next_clone = source.next_clone;
    made.previous_clone = result;
    if (source.next_clone != PreferenceId::kNone) memory.mutable_preference(source.next_clone).previous_clone = clone;
    source.next_clone = clone;
  }
}

/// Returns the match that ends when the justification is no longer valid: a fixed match of its elements or, if negated
/// conditions matter, the match of a literal rule. Returns none if the justification is already invalid. Then only
/// o-supported results are asserted.
MatchId Justifier::MatchOf(std::uint32_t index, InstantiationId id, GoalLevel goal_level) {
  Record& record = records_[index];
  if (record.negations != nullptr) {
    Rete::AddOptions options;
    options.refracted = record.grounds;
    options.instantiation = id;
    const Rete::Added added = uses_.rete.AddProduction(AsRule(index, false), uses_.memory.goal_view(), options);
    if (added.result == Rete::AddResult::kAdded) {
      record.production = added.production;
      return added.refracted;
    }
  }
  const auto has_left = [&](WmeId ground) { return !uses_.memory.record(ground).in_match; };
  if (std::ranges::any_of(record.grounds, has_left)) return MatchId::kNone;
  if (record.plan == nullptr) {
    return uses_.rete.AddFixedMatch(record.grounds, uses_.instantiations[id].goal, goal_level, id);
  }
  // Two conditions may have tested the same element.
  std::vector<WmeId> elements;
  for (const WmeId ground : record.grounds) {
    if (std::ranges::find(elements, ground) == elements.end()) elements.push_back(ground);
  }
  return uses_.rete.AddFixedMatch(elements, uses_.instantiations[id].goal, goal_level, id);
}

void Justifier::InstantiationFreed(InstantiationId id) {
  const std::uint32_t index = uses_.instantiations[id].justification;
  if (index == Instantiation::kNoJustification) return;
  if (records_[index].production != ProductionId::kNone) uses_.rule_changes.LeaveMatch(records_[index].production);
  Record& record = records_[index];
  if (!record.excised) ForgetAlike(index);
  for (const WmeId ground : record.grounds) uses_.changes.DropReference(ground);
  record.grounds.clear();
  record.negations.reset();
  record.negated_classes.clear();
  record.plan.reset();
  record.tests.clear();
  record.live = false;
  free_records_.push_back(index);
}

void Justifier::Excise(std::uint32_t index) {
  Record& record = records_[index];
  ForgetAlike(index);
  record.excised = true;
  const ProductionId production = std::exchange(record.production, ProductionId::kNone);
  if (production != ProductionId::kNone) {
    uses_.rete.ExciseProduction(production);
  } else {
    uses_.rete.RetractFixedMatch(uses_.instantiations[record.instantiation].match);
  }
}

bool Justifier::Excise(std::string_view name) {
  for (const std::uint32_t index : Live()) {
    if (Name(index) != name) continue;
    Excise(index);
    return true;
  }
  return false;
}

std::vector<std::uint32_t> Justifier::Live() const {
  std::vector<std::uint32_t> live;
  for (std::uint32_t index = 0; index < records_.size(); ++index) {
    if (records_[index].live && !records_[index].excised) live.push_back(index);
  }
  std::sort(live.begin(), live.end(),
            [&](std::uint32_t a, std::uint32_t b) { return records_[a].order < records_[b].order; });
  return live;
}

std::string_view Justifier::Name(std::uint32_t index) const {
  if (!records_[index].name.empty()) return records_[index].name;
  // Reserves memory for all names, so that they do not move.
  if (names_.size() < records_.size()) names_.resize(records_.capacity());
  if (names_[index].empty()) names_[index] = NameOfNumber(records_[index].number);
  return names_[index];
}

namespace {

/// A function of a justification with the values of its arguments.
ValueDraft LiteralFunction(const RhsValue& function, std::span<const WmeId> grounds, const WorkingMemory& memory,
                           Arena& arena) {
  ValueDraft out;
  out.kind = RhsValueKind::kFunction;
  out.index = function.function_index();
  for (const RhsValue& argument : function.arguments()) {
    ValueDraft copy;
    if (argument.kind == RhsValueKind::kFunction) {
      copy = LiteralFunction(argument, grounds, memory, arena);
    } else if (argument.kind == RhsValueKind::kBound) {
      copy.symbol = FieldOf(memory.wme(grounds[argument.site().positive_condition]), argument.site().field);
    } else {
      copy.symbol = argument.symbol();
    }
    out.arguments.Add(arena.New(copy));
  }
  return out;
}

}  // namespace

ProductionPtr Justifier::AsRule(std::uint32_t index, bool shown) const {
  const Record& record = records_[index];
  const WorkingMemory& memory = uses_.memory;
  Arena arena;
  RuleDraft rule;
  rule.name = Name(index);
  rule.type = ProductionType::kJustification;
  std::vector<Symbol> states;
  // The other tests of its conditions are true for its elements, so only the text shows them.
  const auto add_tests = [&](std::size_t number, Field field, TestDraft& out) {
    TestDraft both = MakeTest(TestKind::kConjunction);
    for (const IdentityPlan::KeptTest& kept : record.tests) {
      if (kept.condition != number || kept.field != field) continue;
      TestDraft* const test = arena.New(MakeTest(kept.kind, kept.referent));
      if (kept.kind == TestKind::kDisjunction) {
        test->disjuncts = kept.disjuncts.data();
        test->disjunct_count = static_cast<std::uint32_t>(kept.disjuncts.size());
      }
      both.parts.Add(test);
    }
    if (both.parts.empty()) return;
    both.parts.Add(arena.New(out));
    out = both;
  };
  for (std::size_t n = 0; n < record.grounds.size(); ++n) {
    const Wme& wme = memory.wme(record.grounds[n]);
    ConditionDraft* const condition = arena.New<ConditionDraft>();
    condition->id = MakeTest(TestKind::kEqual, wme.id);
    condition->attribute = MakeTest(TestKind::kEqual, wme.attribute);
    condition->value = MakeTest(TestKind::kEqual, wme.value);
    if (shown) {
      add_tests(n, Field::kId, condition->id);
      add_tests(n, Field::kAttribute, condition->attribute);
      add_tests(n, Field::kValue, condition->value);
    }
    if (shown && memory.identifier(wme.id).is_goal && std::ranges::find(states, wme.id) == states.end()) {
      states.push_back(wme.id);
      PrependPart(condition->id, arena.New(MakeTest(TestKind::kState)), arena);
    }
    condition->tests_acceptable = wme.acceptable;
    rule.conditions.Add(condition);
  }
  if (record.negations != nullptr) {
    for (const Condition& negation : record.negations->conditions) {
      rule.conditions.Add(arena.New(ToDraft(negation, arena)));
    }
  }
  for (auto result = record.results.rbegin(); result != record.results.rend(); ++result) {
    ActionDraft* const action = arena.New<ActionDraft>();
    action->preference = result->type;
    action->id = Constant(result->id);
    action->attribute = Constant(result->attribute);
    action->value = Constant(result->value);
    action->referent = Constant(result->referent);
    if (shown && record.functions != nullptr) {
      const auto number = static_cast<std::size_t>(record.results.rend() - result) - 1;
      const Action& computed = record.functions->actions[number];
      if (computed.attribute.kind == RhsValueKind::kFunction) {
        action->attribute = LiteralFunction(computed.attribute, record.grounds, memory, arena);
      }
      if (computed.value.kind == RhsValueKind::kFunction) {
        action->value = LiteralFunction(computed.value, record.grounds, memory, arena);
      }
    }
    rule.actions.Add(action);
  }
  return Production::Make(rule);
}

void Justifier::ExciseAll() {
  for (const std::uint32_t index : Live()) {
    if (records_[index].production != ProductionId::kNone) uses_.rule_changes.LeaveMatch(records_[index].production);
  }
}

void Justifier::Clear() {
  records_.clear();
  free_records_.clear();
  names_.clear();
  next_number_ = 1;
  next_order_ = 0;
  alike_.clear();
  alike_count_ = 0;
}

}  // namespace soarbox::kernel
