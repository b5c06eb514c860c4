// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/reinforcement.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/exploration.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/modules.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/production_record.h"
#include "kernel/decide/rule_changes.h"
#include "kernel/match/rete.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

namespace {

constexpr std::uint32_t kNoJustification = 0xFFFFFFFFu;

bool IsOffPolicy(RlPolicy policy) {
  return policy == RlPolicy::kQLearning || policy == RlPolicy::kOffPolicyGqLambda;
}

bool HasCorrection(RlPolicy policy) {
  return policy == RlPolicy::kOnPolicyGqLambda || policy == RlPolicy::kOffPolicyGqLambda;
}

}  // namespace

Reinforcement::Reinforcement(const Uses& uses)
    : uses_(uses),
      values_(uses.symbols),
      choices_({uses.symbols, uses.memory, uses.goals, uses.counters, uses.exploration}),
      templates_({uses.symbols, uses.memory, uses.expected_values, uses.rule_changes}) {
  uses_.modules.Attach(*this, Modules::kLast);
}

void Reinforcement::Set(const RlSettings& settings) {
  if (settings_.learning && !settings.learning) {
    for (GoalRecord& record : goals_) Forget(record);
  }
  settings_ = settings;
  apoptosis_.Set(settings);
  ModuleHooks hooks = 0;
  if (settings_.learning) hooks |= ModuleHook::kChoices | ModuleHook::kStates | ModuleHook::kHalt;
  if (apoptosis_.on()) hooks |= ModuleHook::kMatches | ModuleHook::kOutputEnd;
  uses_.modules.SetHooks(*this, hooks);
}

Reinforcement::GoalRecord& Reinforcement::Record(GoalLevel level) {
  if (goals_.size() <= level) goals_.resize(level + 1u);
  return goals_[level];
}

void Reinforcement::ForgetPrevious(GoalRecord& record) {
  for (const ProductionId rule : record.previous) --values_.Find(rule)->previous_in;
  record.previous.clear();
}

void Reinforcement::Forget(GoalRecord& record) {
  ForgetPrevious(record);
  record.traces.clear();
  record.reward = 0;
  record.ratio = 1;
  record.gap = record.held = 0;
}

// Rules and preferences -----------------------------------------------------------------------------------------------

ProductionId Reinforcement::LearningRuleOf(PreferenceId preference) const {
  const Instantiation& maker = uses_.instantiations[uses_.memory.preference(preference).instantiation];
  if (maker.production == ProductionId::kNone || maker.justification != kNoJustification) return ProductionId::kNone;
  // (A rule that was just excised may still have matches.)
  if (!uses_.productions[Index(maker.production)].Is(ProductionRecord::kLive)) return ProductionId::kNone;
  return uses_.rete.production(maker.production)->is_rl ? maker.production : ProductionId::kNone;
}

Reinforcement::Future Reinforcement::Judge(const Goal& goal, Symbol value) const {
  const WorkingMemory& memory = uses_.memory;
  Future judged;
  judged.from_rules = false;
  double sum = 0;
  std::uint32_t count = 0;
  for (PreferenceId p = memory.slot(goal.operator_slot).others; p != PreferenceId::kNone;
       p = memory.preference(p).next_in_slot) {
    const Preference& preference = memory.preference(p);
    if (preference.value != value) continue;
    const bool is_number = preference.type == PreferenceType::kNumericIndifferent;
    if (!is_number && preference.type != PreferenceType::kBinaryIndifferent) continue;
    ++count;
    if (!is_number) continue;
    sum += uses_.symbols.NumberValue(preference.referent);
    judged.from_rules = judged.from_rules || LearningRuleOf(p) != ProductionId::kNone;
  }
  judged.value = count > 0 && uses_.exploration.average_numbers ? sum / count : sum;
  return judged;
}

// The hooks -----------------------------------------------------------------------------------------------------------

void Reinforcement::OperatorChosen(GoalLevel level, std::span<const Candidate> candidates, const Candidate& winner) {
  const Goal& goal = uses_.goals.at(level);
  if (settings_.trace) KeepChoice(goal, candidates, winner);
  for (GoalLevel each = 1; each <= uses_.goals.depth(); ++each) Collect(each);
  Future next = Judge(goal, winner.value);
  chosen_ratio_ = 1;
  if (candidates.size() > 1 && IsOffPolicy(settings_.policy)) {
    // The best candidate counts, whichever one was selected.
    const Candidate* best = &candidates.front();
    double highest = NumericValue(*best, uses_.exploration);
    std::uint32_t ties = 0;
    for (const Candidate& candidate : candidates) {
      const double value = NumericValue(candidate, uses_.exploration);
      if (value > highest) {
        best = &candidate;
        highest = value;
        ties = 0;
      }
      if (value == highest) ++ties;
    }
    const bool greedy = NumericValue(winner, uses_.exploration) == highest;
    const ExplorationPolicy exploration = uses_.exploration.policy;
    if (settings_.policy == RlPolicy::kOffPolicyGqLambda && exploration != ExplorationPolicy::kFirst &&
        exploration != ExplorationPolicy::kLast) {
      const std::vector<double> chances = SelectionChances(candidates, uses_.exploration);
      const auto at = std::ranges::find(candidates, winner.value, &Candidate::value) - candidates.begin();
      chosen_ratio_ = greedy ? 1.0 / ties / chances[static_cast<std::size_t>(at)] : 0;
    }
    next = Judge(goal, best->value);
    Update(level, next);
    if (settings_.policy == RlPolicy::kQLearning && !greedy) Record(level).traces.clear();
    return;
  }
  Update(level, next);
}

void Reinforcement::KeepChoice(const Goal& goal, std::span<const Candidate> candidates, const Candidate& winner) {
  std::vector<bool> learned;
  for (const Candidate& candidate : candidates) learned.push_back(Judge(goal, candidate.value).from_rules);
  choices_.Add(goal.level, candidates, winner, learned);
}

void Reinforcement::Note(GoalRecord& record, ProductionId rule) {
  ++values_.Of(rule, *uses_.rete.production(rule)).previous_in;
  record.previous.push_back(rule);
}

void Reinforcement::OperatorInstalled(GoalLevel level, Symbol op) {
  const Goal& goal = uses_.goals.at(level);
  const WorkingMemory& memory = uses_.memory;
  GoalRecord& record = Record(level);
  bool any = false;
  for (PreferenceId p = memory.slot(goal.operator_slot).others; p != PreferenceId::kNone;
       p = memory.preference(p).next_in_slot) {
    const Preference& preference = memory.preference(p);
    if (preference.type != PreferenceType::kNumericIndifferent || preference.value != op) continue;
    const ProductionId rule = LearningRuleOf(p);
    if (rule == ProductionId::kNone) continue;
    if (!any) {
      ForgetPrevious(record);
      any = true;
    }
    Note(record, rule);
  }
  if (any) {
    record.ratio = chosen_ratio_;
    return;
  }
  if (!settings_.temporal_extension) {
    ForgetPrevious(record);
    record.ratio = 1;
    return;
  }
  if (record.previous.empty()) return;
  if (record.gap == 0) {
    uses_.observers.Notify(Event::kReinforcement, [&](Observer& o) { o.OnRewardGap(uses_.agent, goal.id, true); });
  }
  ++record.gap;
}

void Reinforcement::StateEnds(GoalLevel level) {
  if (level > 1) {
    Collect(level);
    Update(level, {.value = 0, .from_rules = true, .expected = false});
  }
  Forget(Record(level));
  choices_.Begin(level);
}

void Reinforcement::Halted() {
  for (auto level = static_cast<GoalLevel>(uses_.goals.depth()); level >= 1; --level) {
    Collect(level);
    Update(level, {});
  }
}

void Reinforcement::RuleAdded(ProductionId rule, const Production& production) {
  templates_.RuleAdded(production.name);
  if (settings_.meta && production.is_rl) values_.ReadDocumentation(rule, production);
}

void Reinforcement::RuleExcised(ProductionId rule) {
  templates_.RuleExcised(rule);
  if (apoptosis_.on()) apoptosis_.RuleExcised(rule);
  if (values_.Find(rule) == nullptr) return;
  for (GoalRecord& record : goals_) {
    std::erase(record.previous, rule);
    std::erase_if(record.traces, [&](const Trace& trace) { return trace.rule == rule; });
  }
  values_.Forget(rule);
}

void Reinforcement::Mark(const std::function<void(Symbol)>& mark) {
  values_.ForEach([&](const RlValue& value) { mark(value.value); });
}

void Reinforcement::AfterInit() {
  for (GoalRecord& record : goals_) Forget(record);
  choices_.Begin(1);
  apoptosis_.Clear();
  statistics_ = RlStatistics();
}

// Removing unused rules -----------------------------------------------------------------------------------------------

bool Reinforcement::IsUnused(ProductionId rule) const {
  const Production& production = *uses_.rete.production(rule);
  if (production.type != ProductionType::kChunk) return false;
  if (!production.is_rl) return apoptosis_.mode() == ApoptosisMode::kChunks;
  const RlValue* const value = values_.Find(rule);
  return value == nullptr || (value->updates < 1 && value->previous_in == 0);
}

void Reinforcement::MatchEnded(ProductionId rule) {
  if (rule == ProductionId::kNone || !uses_.productions[Index(rule)].Is(ProductionRecord::kLive)) return;
  if (IsUnused(rule)) apoptosis_.Used(rule);
}

void Reinforcement::OutputEnd() {
  for (const ProductionId rule : apoptosis_.EndDecision()) {
    const MatchSet& matches = uses_.rete.matches();
    bool matched = false;
    matches.ForEachMatch([&](MatchId match) {
      matched = matched || (matches.ProductionOf(match) == Index(rule) && matches.StateOf(match) == MatchState::kFired);
    });
    if (!matched && IsUnused(rule)) uses_.rule_changes.Excise(rule);
  }
}

// Reward --------------------------------------------------------------------------------------------------------------

double Reinforcement::RewardOf(Symbol reward_link) const {
  const WorkingMemory& memory = uses_.memory;
  const SlotId rewards = memory.FindSlot(reward_link, words::kReward);
  if (rewards == SlotId::kNone) return 0;
  double sum = 0;
  for (WmeId reward = memory.slot(rewards).wmes; reward != WmeId::kNone; reward = memory.record(reward).next) {
    if (!memory.wme(reward).value.IsIdentifier()) continue;
    const SlotId values = memory.FindSlot(memory.wme(reward).value, words::kValue);
    if (values == SlotId::kNone) continue;
    for (WmeId value = memory.slot(values).wmes; value != WmeId::kNone; value = memory.record(value).next) {
      const Symbol number = memory.wme(value).value;
      if (number.IsNumber()) sum += uses_.symbols.NumberValue(number);
    }
  }
  return sum;
}

void Reinforcement::Collect(GoalLevel level) {
  GoalRecord& record = Record(level);
  if (record.previous.empty()) return;
  const double reward = RewardOf(uses_.goals.at(level).reward_link);
  const std::uint32_t age = record.held + (settings_.temporal_discount ? record.gap : 0);
  record.reward += reward * std::pow(settings_.discount_rate, age);
  statistics_.reward = reward;
  statistics_.total_reward += reward;
  if (settings_.hrl_discount && level < uses_.goals.depth()) ++record.held;
}

// Updating ------------------------------------------------------------------------------------------------------------

void Reinforcement::Update(GoalLevel level, const Future& future) {
  if (settings_.temporal_extension && !future.from_rules) return;
  GoalRecord& record = Record(level);
  if (!record.previous.empty()) {
    const Goal& goal = uses_.goals.at(level);
    if (record.gap > 0 && settings_.temporal_extension) {
      uses_.observers.Notify(Event::kReinforcement, [&](Observer& o) { o.OnRewardGap(uses_.agent, goal.id, false); });
    }
    const std::uint32_t age = record.held + 1 + (settings_.temporal_discount ? record.gap : 0);
    const double discount = std::pow(settings_.discount_rate, age);
    AdvanceTraces(record, discount, level < uses_.goals.depth());

    double current = 0, expected = 0, previous_product = 0, trace_product = 0;
    for (const ProductionId rule : record.previous) {
      const RlValue& value = *values_.Find(rule);
      current += value.current;
      expected += value.future;
      previous_product += value.correction;
    }
    for (const Trace& trace : record.traces) trace_product += values_.Find(trace.rule)->correction * trace.weight;

    ++update_;
    const Step step{record.reward - current, discount * future.value - expected,
                    record.reward + discount * future.value - (current + expected), future.expected};
    Symbol shown;
    for (const Trace& trace : record.traces) Move(trace, step, shown);
    if (HasCorrection(settings_.policy)) CorrectGradient(goal, record, trace_product, previous_product);
    if (settings_.meta) {
      for (const Trace& trace : record.traces) values_.Document(*values_.Find(trace.rule));
    }
    if (shown) ShowInPreferences(shown);
  }
  record.gap = record.held = 0;
  record.reward = 0;
}

void Reinforcement::AdvanceTraces(GoalRecord& record, double discount, bool has_substate) {
  if (settings_.trace_decay == 0) {
    record.traces.clear();
  } else {
    for (Trace& trace : record.traces) {
      trace.weight *= settings_.trace_decay;
      trace.weight *= discount;
    }
    std::erase_if(record.traces, [&](const Trace& trace) { return trace.weight < settings_.trace_tolerance; });
  }
  if (HasCorrection(settings_.policy)) {
    for (Trace& trace : record.traces) trace.weight *= record.ratio;
  }
  // While an operator is being implemented in a substate, its decision has not ended. The rules then count as updated,
  // but nothing is added to their traces.
  const double share = has_substate ? 0 : 1.0 / static_cast<double>(record.previous.size());
  for (const ProductionId rule : record.previous) {
    const auto at = std::ranges::lower_bound(record.traces, rule, {}, &Trace::rule);
    if (at != record.traces.end() && at->rule == rule) {
      at->weight += share;
    } else {
      record.traces.insert(at, {rule, share});
    }
  }
}

double Reinforcement::RateOf(RlValue& value, double error) const {
  switch (settings_.decay) {
    case RlDecay::kNormal:
      break;
    case RlDecay::kExponential:
      return 1 / (value.updates + 1);
    case RlDecay::kLogarithmic:
      return 1 / (std::log(value.updates + 1) + 1);
    case RlDecay::kDeltaBarDelta: {
      value.beta += settings_.meta_learning_rate * error * value.h;
      const double rate = std::exp(value.beta);
      value.h = value.h * std::max(0.0, 1 - rate) + rate * error;
      return rate;
    }
  }
  return settings_.learning_rate;
}

void Reinforcement::Move(const Trace& trace, const Step& step, Symbol& shown) {
  RlValue& value = *values_.Find(trace.rule);
  const double rate = RateOf(value, step.error);
  const double current = rate * trace.weight * step.current_error;
  const double future = step.expected ? rate * trace.weight * step.future_error : 0;
  const RlUpdate told{trace.rule, value.current, value.future, value.current + current, value.future + future};
  uses_.observers.Notify(Event::kReinforcement, [&](Observer& o) { o.OnRlUpdate(uses_.agent, told); });
  value.current += current;
  value.future += future;
  value.correction += settings_.step_size * (current + future);
  value.updates += 1;
  value.mark = update_;
  shown = value.value = uses_.symbols.Float(value.current + value.future);
}

void Reinforcement::CorrectGradient(const Goal& goal, const GoalRecord& record, double trace_product,
                                    double previous_product) {
  const WorkingMemory& memory = uses_.memory;
  const double rate = settings_.learning_rate;
  const double towards = rate * settings_.discount_rate * (1 - settings_.trace_decay) * trace_product;
  for (PreferenceId p = memory.slot(goal.operator_slot).others; p != PreferenceId::kNone;
       p = memory.preference(p).next_in_slot) {
    if (memory.preference(p).type != PreferenceType::kNumericIndifferent) continue;
    const ProductionId rule = LearningRuleOf(p);
    if (rule == ProductionId::kNone) continue;
    values_.Of(rule, *uses_.rete.production(rule)).future -= towards;
  }
  for (const ProductionId rule : record.previous) {
    values_.Find(rule)->correction -= rate * settings_.step_size * previous_product;
  }
}

// As in Soar 9.6.3, all of these preferences get the number of the rule that was updated last. Slots are not decided
// again.
void Reinforcement::ShowInPreferences(Symbol shown) {
  WorkingMemory& memory = uses_.memory;
  for (GoalLevel level = 1; level <= uses_.goals.depth(); ++level) {
    PreferenceId next;
    for (PreferenceId p = memory.slot(uses_.goals.at(level).operator_slot).others; p != PreferenceId::kNone; p = next) {
      const Preference& preference = memory.preference(p);
      next = preference.next_in_slot;
      if (preference.type != PreferenceType::kNumericIndifferent) continue;
      const ProductionId rule = LearningRuleOf(p);
      if (rule == ProductionId::kNone || uses_.instantiations[preference.instantiation].match == MatchId::kNone) {
        continue;
      }
      const RlValue* const value = values_.Find(rule);
      if (value != nullptr && value->mark == update_) memory.mutable_preference(p).referent = shown;
    }
  }
}

}  // namespace soarbox::kernel
