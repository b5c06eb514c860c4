// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/justification.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "kernel/base/words.h"
#include "kernel/decide/engine.h"

namespace soarbox::kernel {
namespace {

/// Marks `index` for this trace; false if it was marked already.
bool Mark(std::vector<std::uint32_t>& marks, std::uint32_t index, std::uint32_t trace) {
  if (marks.size() <= index) marks.resize(index + 1u, 0);
  if (marks[index] == trace) return false;
  marks[index] = trace;
  return true;
}

std::string NameOfNumber(std::uint32_t number) {
  return "justify" + std::to_string(number);
}

ValueDraft Constant(Symbol symbol) {
  ValueDraft value;
  value.symbol = symbol;
  return value;
}

}  // namespace

void Justifier::Consider(InstantiationId id) {
  for (InstantiationId current = id; engine_.instantiations[current].level > 1;) {
    level_ = engine_.instantiations[current].level;
    ++trace_number_;
    results_.clear();
    if (!CollectResults(current)) return;
    if (!duplicates_.empty() && HasTooManyDuplicates(current)) {
      engine_.Warn(WarningKind::kMaxDuplicates, engine_.DescribeInstantiation(current).name);
      return;
    }
    Backtrace(current);
    current = Build(current);
    if (current == InstantiationId::kNone) return;
  }
}

// Results -------------------------------------------------------------------------------------------------------------

bool Justifier::CollectResults(InstantiationId id) {
  const WorkingMemory& memory = engine_.memory;
  for (PreferenceId p = engine_.instantiations[id].preferences; p != PreferenceId::kNone;
       p = memory.preference(p).next_of_instantiation) {
    if (memory.level(memory.preference(p).id) >= level_) continue;
    parts_.push_back({p, Symbol()});
    // Depth first, with a stack of our own: structures may be as long as memory is.
    while (!parts_.empty()) {
      const Part part = parts_.back();
      parts_.pop_back();
      if (part.preference != PreferenceId::kNone) {
        AddResult(part.preference);
      } else {
        AddPartsOf(part.object, id);
      }
    }
  }
  return !results_.empty();
}

void Justifier::AddResult(PreferenceId preference) {
  if (engine_.memory.preference(preference).level != level_) {
    preference = engine_.firing.CloneAtLevel(preference, level_);
    if (preference == PreferenceId::kNone) return;
  }
  std::uint32_t& seen = engine_.memory.mutable_preference(preference).seen;
  if (std::exchange(seen, trace_number_) == trace_number_) return;
  const Preference& content = engine_.memory.preference(preference);
  // A result that says the same as another one adds nothing.
  const Record::Result says = ResultOf(preference);
  if (std::ranges::any_of(results_, [&](PreferenceId other) { return ResultOf(other) == says; })) return;
  results_.push_back(preference);
  parts_.push_back({PreferenceId::kNone, content.referent});
  parts_.push_back({PreferenceId::kNone, content.value});
}

/// An object of the substate that becomes part of a result brings all it consists of: a state, too, which then hangs on
/// nothing but what it is made of.
void Justifier::AddPartsOf(Symbol id, InstantiationId base) {
  const WorkingMemory& memory = engine_.memory;
  if (!id.IsIdentifier() || memory.level(id) < level_) return;
  if (!Mark(seen_identifiers_, id.index(), trace_number_)) return;
  const IdentifierRecord& record = memory.identifier(id);
  const std::size_t first_part = parts_.size();
  for (WmeId wme = record.input_wmes; wme != WmeId::kNone; wme = memory.record(wme).next) {
    parts_.push_back({PreferenceId::kNone, memory.wme(wme).value});
  }
  for (SlotId slot = record.slots; slot != SlotId::kNone; slot = memory.slot(slot).next) {
    const std::size_t first_preference = parts_.size();
    for (const PreferenceId first : {memory.slot(slot).acceptable, memory.slot(slot).others}) {
      for (PreferenceId p = first; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
        parts_.push_back({p, Symbol()});
      }
    }
    // Newest first, whatever their level and type.
    std::sort(parts_.begin() + static_cast<std::ptrdiff_t>(first_preference), parts_.end(),
              [&](const Part& a, const Part& b) {
                return memory.preference(a.preference).stamp > memory.preference(b.preference).stamp;
              });
    for (WmeId wme = memory.slot(slot).wmes; wme != WmeId::kNone; wme = memory.record(wme).next) {
      if (memory.record(wme).preference != PreferenceId::kNone) continue;
      parts_.push_back({PreferenceId::kNone, memory.wme(wme).value});
    }
  }
  // What the same firing says of it is not in its slots yet.
  for (PreferenceId p = engine_.instantiations[base].preferences; p != PreferenceId::kNone;
       p = memory.preference(p).next_of_instantiation) {
    if (memory.preference(p).id == id) parts_.push_back({p, Symbol()});
  }
  std::reverse(parts_.begin() + static_cast<std::ptrdiff_t>(first_part), parts_.end());
}

// What they rest on ---------------------------------------------------------------------------------------------------

void Justifier::Backtrace(InstantiationId base) {
  grounds_.clear();
  lowest_ground_ = 0;
  operator_grounds_.clear();
  negations_.clear();
  drafts_.Clear();
  queue_.clear();
  VisitInstantiation(base);
  for (auto result = results_.rbegin(); result != results_.rend(); ++result) {
    VisitInstantiation(engine_.memory.preference(*result).instantiation);
  }
  VisitQueued();
  // What was found last is tested first.
  std::reverse(grounds_.begin(), grounds_.end());
  std::reverse(negations_.begin(), negations_.end());
}

/// The grounds of a firing are taken at once, what it rests on in the substate later: the last one first.
void Justifier::VisitQueued() {
  while (!queue_.empty()) {
    const Open open = queue_.back();
    queue_.pop_back();
    if (open.instantiation != InstantiationId::kNone) {
      VisitInstantiation(open.instantiation);
    } else {
      VisitItem(open.item);
    }
  }
}

void Justifier::VisitInstantiation(InstantiationId id) {
  Instantiation& instantiation = engine_.instantiations[id];
  if (instantiation.backtrace == trace_number_) return;
  instantiation.backtrace = trace_number_;
  for (const ConditionTrace& trace : engine_.instantiations.Trace(id)) VisitCondition(trace);
  CollectNegations(id);
}

inline void Justifier::AddGround(WmeId ground) {
  grounds_.push_back(ground);
  const Wme& wme = engine_.memory.wme(ground);
  const GoalLevel goal = engine_.memory.goal_levels()[wme.id.index()];
  if (goal == 0) return;
  lowest_ground_ = std::max(lowest_ground_, goal);
  if (wme.attribute == words::kOperator && !wme.acceptable) operator_grounds_.push_back(ground);
}

/// An item of an impasse rests on the proposal in the superstate.
void Justifier::VisitItem(WmeId item) {
  if (level_ < 2 || engine_.memory.wme(item).id != engine_.goals.at(level_).id) return;
  const WmeId proposal = engine_.goal_changes.ProposalOfItem(item);
  if (proposal != WmeId::kNone && Mark(seen_wmes_, Index(proposal), trace_number_)) AddGround(proposal);
}

inline void Justifier::VisitCondition(const ConditionTrace& trace) {
  if (trace.level < level_) {
    if (Mark(seen_wmes_, Index(trace.wme), trace_number_)) AddGround(trace.wme);
    return;
  }
  if (trace.preference == PreferenceId::kNone) {  // Of the architecture: it came with the substate.
    queue_.push_back({InstantiationId::kNone, trace.wme});
    return;
  }
  const WorkingMemory& memory = engine_.memory;
  const Preference& made_by = memory.preference(trace.preference);
  queue_.push_back({made_by.instantiation, WmeId::kNone});
  // The selected operator also rests on what made it better than others.
  if (made_by.attribute != words::kOperator || memory.wme(trace.wme).acceptable || made_by.slot == SlotId::kNone)
    return;
  for (PreferenceId p = memory.slot(made_by.slot).others; p != PreferenceId::kNone;
       p = memory.preference(p).next_in_slot) {
    const Preference& evaluation = memory.preference(p);
    const PreferenceId local = engine_.firing.CloneAtLevel(p, level_);
    if (local == PreferenceId::kNone) continue;
    const bool decided = evaluation.type == PreferenceType::kProhibit || evaluation.type == PreferenceType::kReject ||
                         evaluation.value == made_by.value || evaluation.referent == made_by.value;
    if (decided) queue_.push_back({memory.preference(local).instantiation, WmeId::kNone});
  }
}

#ifdef SOARBOX_CHECK_INVARIANTS
/// Aborts if something that the results reach is not one of them: it would lose its support with the substate.
void Justifier::CheckResults() const {
  const WorkingMemory& memory = engine_.memory;
  std::vector<Symbol> reached;
  const auto reach = [&](Symbol id) {
    if (id.IsIdentifier() && memory.level(id) >= level_ && std::ranges::find(reached, id) == reached.end()) {
      reached.push_back(id);
    }
  };
  for (const PreferenceId result : results_) {
    reach(memory.preference(result).value);
    reach(memory.preference(result).referent);
  }
  for (std::size_t n = 0; n < reached.size(); ++n) {
    for (SlotId slot = memory.identifier(reached[n]).slots; slot != SlotId::kNone; slot = memory.slot(slot).next) {
      for (const PreferenceId first : {memory.slot(slot).acceptable, memory.slot(slot).others}) {
        for (PreferenceId p = first; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
          const PreferenceId local = engine_.firing.CloneAtLevel(p, level_);
          if (local == PreferenceId::kNone) continue;
          reach(memory.preference(p).value);
          reach(memory.preference(p).referent);
          if (memory.preference(local).seen == trace_number_) continue;
          std::fprintf(stderr, "soarbox: a result lacks a part: (%s ^%s %s)\n",
                       ToString(engine_.symbols, memory.preference(p).id).c_str(),
                       ToString(engine_.symbols, memory.preference(p).attribute).c_str(),
                       ToString(engine_.symbols, memory.preference(p).value).c_str());
          std::abort();
        }
      }
    }
  }
}
#endif

// Negated conditions --------------------------------------------------------------------------------------------------

namespace {

/// The value that the instantiation gave a variable, or the none symbol.
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

ConditionDraft Justifier::Instantiate(const Condition& condition, InstantiationId id) {
  ConditionDraft copy = ToDraft(condition, drafts_);
  const Production& rule = *engine_.rete.production(engine_.instantiations[id].production);
  InstantiateCondition(copy, rule, engine_.instantiations.Trace(id), engine_.memory);
  return copy;
}

bool Justifier::RefersToHigherOnly(const ConditionDraft& condition) const {
  if (condition.kind == ConditionKind::kConjunctiveNegation) {
    for (const ConditionDraft& inner : condition.conditions) {
      if (!RefersToHigherOnly(inner)) return false;
    }
    return true;
  }
  const Symbol id = EqualitySymbol(condition.id);
  return !id.IsIdentifier() || engine_.memory.level(id) < level_;
}

bool Justifier::MayReferToHigherOnly(const Condition& condition, InstantiationId id) const {
  if (condition.kind == ConditionKind::kConjunctiveNegation) {
    return std::ranges::all_of(condition.conditions(),
                               [&](const Condition& inner) { return MayReferToHigherOnly(inner, id); });
  }
  Symbol object = EqualitySymbol(condition.id);
  if (object.IsVariable()) {
    const Production& rule = *engine_.rete.production(engine_.instantiations[id].production);
    object = ValueOfVariable(rule, object, engine_.instantiations.Trace(id), engine_.memory);
  }
  return !object.IsIdentifier() || engine_.memory.level(object) < level_;
}

void Justifier::CollectNegations(InstantiationId id) {
  const Instantiation& instantiation = engine_.instantiations[id];
  if (instantiation.production == ProductionId::kNone) {
    if (instantiation.justification != 0xFFFFFFFFu) {
      const ProductionPtr& known = records_[instantiation.justification].negations;
      if (known == nullptr) return;
      for (const Condition& negation : known->conditions) {
        const ConditionDraft copy = ToDraft(negation, drafts_);
        if (RefersToHigherOnly(copy)) negations_.push_back(copy);
      }
    }
    return;
  }
  if (!engine_.productions[Index(instantiation.production)].Is(Engine::ProductionRecord::kHasNegations)) return;
  const ProductionPtr& rule = engine_.rete.production(instantiation.production);
  if (rule == nullptr) return;
  for (const Condition& condition : rule->conditions) {
    if (condition.kind == ConditionKind::kPositive || !MayReferToHigherOnly(condition, id)) continue;
    const ConditionDraft literal = Instantiate(condition, id);
    if (!RefersToHigherOnly(literal)) continue;
    if (std::find(negations_.begin(), negations_.end(), literal) == negations_.end()) {
      negations_.push_back(literal);
    }
  }
}

// The justification ---------------------------------------------------------------------------------------------------

/// Whether the actions of the rule that fired last propose an operator to a state. As in Soar 9.6.3 that is not asked
/// of a rule whose last condition is a negated one.
bool Justifier::Proposes(InstantiationId base) const {
  const WorkingMemory& memory = engine_.memory;
  const Instantiation& instantiation = engine_.instantiations[base];
  if (instantiation.justification != 0xFFFFFFFFu) {
    const Record& record = records_[instantiation.justification];
    return instantiation.match != MatchId::kNone && record.negations == nullptr &&
           std::ranges::any_of(record.results, [&](const Record::Result& result) {
             return result.type == PreferenceType::kAcceptable && result.attribute == words::kOperator &&
                    memory.identifier(result.id).is_goal;
           });
  }
  if (instantiation.production == ProductionId::kNone) return false;
  const Production& rule = *engine_.rete.production(instantiation.production);
  if (rule.conditions.empty() || rule.conditions.back().kind != ConditionKind::kPositive) return false;
  const std::span<const ConditionTrace> traces = engine_.instantiations.Trace(base);
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

bool Justifier::IsOSupported(InstantiationId base, InstantiationId made, GoalLevel goal_level) {
  const WorkingMemory& memory = engine_.memory;
  if (operator_grounds_.empty() || Proposes(base)) return false;
  const Symbol goal = engine_.goals.at(goal_level).id;
  bool elaborates = false, applies = false;
  for (const WmeId ground : operator_grounds_) {
    if (memory.wme(ground).id != goal) continue;
    for (const PreferenceId result : results_) {
      (memory.preference(result).id == memory.wme(ground).value ? elaborates : applies) = true;
    }
  }
  if (!elaborates || !applies || !engine_.settings.warn_of_mixed_support) return applies;
  engine_.Print("\nWARNING:  Operator elaborations mixed with operator applications\nAssigning i_support to prod " +
                std::string(engine_.ProductionName(made)));
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
  // Numbers go up by two, as in Soar 9.6.3.
  record.number = next_number_;
  next_number_ += 2;
  if (index < names_.size()) names_[index].clear();
  return index;
}

// The justification ---------------------------------------------------------------------------------------------------

InstantiationId Justifier::Build(InstantiationId base) {
  WorkingMemory& memory = engine_.memory;
  GoalLevel goal_level = lowest_ground_;
  if (goal_level == 0) {
    if (grounds_.empty()) {
      engine_.Warn(WarningKind::kUnconditional, engine_.DescribeInstantiation(base).name);
      return InstantiationId::kNone;
    }
    goal_level = static_cast<GoalLevel>(level_ - 1);
  }
  const std::uint32_t digest = DigestOfResults();
  const std::uint32_t original = OriginalOf(digest);
  if (original != 0xFFFFFFFFu) {
    if (engine_.observers.Wants(Event::kLearning)) {
      const std::string name = NameOfNumber(next_number_);
      engine_.observers.Notify(Event::kLearning,
                               [&](Observer& o) { o.OnDuplicateLearned(engine_.agent, name, Name(original)); });
    }
    next_number_ += 2;
    CountDuplicate(base);
    // What nothing holds yet goes with the justification that is not made: these firings leave no preferences.
    for (const PreferenceId result : results_) engine_.preferences.FreeIfUnused(result);
    return InstantiationId::kNone;
  }
  const std::uint32_t index = NewRecord();
  const InstantiationId id = engine_.instantiations.Make();
  Instantiation& instantiation = engine_.instantiations[id];
  instantiation.goal = engine_.goals.at(goal_level).id;
  instantiation.level = goal_level;
  instantiation.held = true;
  instantiation.justification = index;
  Record& record = records_[index];
  record.instantiation = id;
  record.grounds = grounds_;
  for (const WmeId ground : grounds_) engine_.changes.AddReference(ground);
  if (!negations_.empty()) {
    RuleDraft kept;
    for (ConditionDraft& negation : negations_) kept.conditions.Add(&negation);
    record.negations = Production::Make(kept);
  }
  record.results.clear();
  for (const PreferenceId result : results_) record.results.push_back(ResultOf(result));
  record.digest = digest;
  NoteAlike(index);
#ifdef SOARBOX_CHECK_INVARIANTS
  CheckResults();
#endif
  ++engine_.counters.justifications;
  if (goal_level > 1) engine_.firing.TraceConditions(id, grounds_);

  if (engine_.observers.Wants(Event::kLearning)) {
    const FiringInfo info = engine_.DescribeInstantiation(id);
    engine_.observers.Notify(Event::kLearning, [&](Observer& o) { o.OnLearned(engine_.agent, info); });
  }

  // Clones of the results, one level up. The list is newest first, so the last result is made first.
  const bool o_support = IsOSupported(base, id, goal_level);
  for (std::size_t n = results_.size(); n-- > 0;) {
    const PreferenceId result = results_[n];
    const Preference& original = memory.preference(result);
    const PreferenceId clone = engine_.preferences.Make(id, original.id, original.attribute, original.value,
                                                        original.referent, original.type, o_support);
    Preference& made = memory.mutable_preference(clone);
    Preference& source = memory.mutable_preference(result);
    made.next_clone = source.next_clone;
    made.previous_clone = result;
    if (source.next_clone != PreferenceId::kNone) memory.mutable_preference(source.next_clone).previous_clone = clone;
    source.next_clone = clone;
  }
  engine_.instantiations[id].o_support = o_support;
  engine_.instantiations[id].match = MatchOf(index, id, goal_level);
  engine_.preferences.LinkToGoal(id);
  engine_.firing.made().push_back(id);
  return id;
}

/// What tells when the justification no longer holds: the elements of a fixed match, or the literal rule if negated
/// conditions matter. None if it does not hold even now: then only what is o-supported will be asserted.
MatchId Justifier::MatchOf(std::uint32_t index, InstantiationId id, GoalLevel goal_level) {
  Record& record = records_[index];
  if (record.negations != nullptr) {
    Rete::AddOptions options;
    options.refracted = record.grounds;
    options.instantiation = id;
    const Rete::Added added = engine_.rete.AddProduction(AsRule(index, false), engine_.goal_view(), options);
    if (added.result == Rete::AddResult::kAdded) {
      record.production = added.production;
      return added.refracted;
    }
  }
  const auto has_left = [&](WmeId ground) { return !engine_.memory.record(ground).in_match; };
  if (std::ranges::any_of(record.grounds, has_left)) return MatchId::kNone;
  return engine_.rete.AddFixedMatch(record.grounds, engine_.instantiations[id].goal, goal_level, id);
}

void Justifier::InstantiationFreed(InstantiationId id) {
  const std::uint32_t index = engine_.instantiations[id].justification;
  if (index == 0xFFFFFFFFu) return;
  if (records_[index].production != ProductionId::kNone) engine_.ExciseLater(records_[index].production);
  Record& record = records_[index];
  if (!record.excised) ForgetAlike(index);
  for (const WmeId ground : record.grounds) engine_.changes.DropReference(ground);
  record.grounds.clear();
  record.negations.reset();
  record.live = false;
  free_records_.push_back(index);
}

bool Justifier::Excise(std::string_view name) {
  for (const std::uint32_t index : Live()) {
    if (Name(index) != name) continue;
    Record& record = records_[index];
    ForgetAlike(index);
    record.excised = true;
    const ProductionId production = std::exchange(record.production, ProductionId::kNone);
    if (production != ProductionId::kNone) {
      engine_.rete.ExciseProduction(production);
    } else {
      engine_.rete.RetractFixedMatch(engine_.instantiations[record.instantiation].match);
    }
    return true;
  }
  return false;
}

void Justifier::SetLearning(Symbol state, bool learn) {
  std::vector<Symbol>& states = learn ? force_learn_ : dont_learn_;
  if (std::find(states.begin(), states.end(), state) == states.end()) states.push_back(state);
}

std::vector<std::uint32_t> Justifier::Live() const {
  std::vector<std::uint32_t> live;
  for (std::uint32_t index = 0; index < records_.size(); ++index) {
    if (records_[index].live && !records_[index].excised) live.push_back(index);
  }
  std::sort(live.begin(), live.end(),
            [&](std::uint32_t a, std::uint32_t b) { return records_[a].number < records_[b].number; });
  return live;
}

std::string_view Justifier::Name(std::uint32_t index) const {
  // Room for all, so that the texts stay where they are.
  if (names_.size() < records_.size()) names_.resize(records_.capacity());
  if (names_[index].empty()) names_[index] = NameOfNumber(records_[index].number);
  return names_[index];
}

ProductionPtr Justifier::AsRule(std::uint32_t index, bool shown) const {
  const Record& record = records_[index];
  const WorkingMemory& memory = engine_.memory;
  Arena arena;
  RuleDraft rule;
  rule.name = Name(index);
  rule.type = ProductionType::kJustification;
  std::vector<Symbol> states;
  for (const WmeId ground : record.grounds) {
    const Wme& wme = memory.wme(ground);
    ConditionDraft* const condition = arena.New<ConditionDraft>();
    condition->id = MakeTest(TestKind::kEqual, wme.id);
    if (shown && memory.identifier(wme.id).is_goal && std::ranges::find(states, wme.id) == states.end()) {
      states.push_back(wme.id);
      TestDraft both = MakeTest(TestKind::kConjunction);
      both.parts.Add(arena.New(MakeTest(TestKind::kState)));
      both.parts.Add(arena.New(condition->id));
      condition->id = both;
    }
    condition->attribute = MakeTest(TestKind::kEqual, wme.attribute);
    condition->value = MakeTest(TestKind::kEqual, wme.value);
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
    rule.actions.Add(action);
  }
  return Production::Make(rule);
}

void Justifier::ExciseAll() {
  for (const std::uint32_t index : Live()) {
    if (records_[index].production != ProductionId::kNone) engine_.ExciseLater(records_[index].production);
  }
}

void Justifier::Clear() {
  records_.clear();
  free_records_.clear();
  names_.clear();
  next_number_ = 1;
  alike_.clear();
  alike_count_ = 0;
  duplicates_.clear();
  dont_learn_.clear();
  force_learn_.clear();
  seen_identifiers_.clear();
  seen_wmes_.clear();
  trace_number_ = 0;
}

}  // namespace soarbox::kernel
