// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/module.h"
#include "kernel/decide/preference_semantics.h"
#include "kernel/learn/apoptosis.h"
#include "kernel/learn/choice_graph.h"
#include "kernel/learn/rl_settings.h"
#include "kernel/learn/rl_template.h"
#include "kernel/learn/rl_values.h"

namespace soarbox::kernel {

class Agent;
struct AgentCounters;
struct AgentSettings;
class ExpectedValues;
struct ExplorationSettings;
struct Goal;
class GoalStack;
class InstantiationTable;
class Modules;
class Observers;
class ProductionRecord;
class Rete;
class RuleChanges;
class SymbolTable;
class WorkingMemory;

/// The statistics of `rl --stats`.
struct RlStatistics {
  double reward = 0;        ///< The reward of the last decision that collected any.
  double total_reward = 0;  ///< Since init-soar.
};

/// Reinforcement learning: updates the numbers of rules whose only action is a numeric preference for an operator.
///
/// When an operator is selected in a goal, the rewards of all goals are collected. The rules that supported the goal's
/// previous operator are updated towards the reward plus the discounted value of the new operator. Then the rules that
/// support the new operator are stored for the next update. The reward is the sum of the numbers at (reward-link
/// ^reward.value).
///
/// Each agent has its own. Shared rules and networks are only read.
class Reinforcement final : public Module {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    Agent& agent;
    SymbolTable& symbols;
    WorkingMemory& memory;
    const GoalStack& goals;
    const InstantiationTable& instantiations;
    const Rete& rete;
    const AgentSettings& settings;
    const AgentCounters& counters;
    const ExplorationSettings& exploration;
    const ExpectedValues& expected_values;
    const std::vector<ProductionRecord>& productions;
    const Observers& observers;
    RuleChanges& rule_changes;
    Modules& modules;
  };
  explicit Reinforcement(const Uses& uses);

  bool learning() const { return settings_.learning; }
  const RlSettings& settings() const { return settings_; }
  /// Disabling learning discards the data for the next update; learned values stay.
  void Set(const RlSettings& settings);

  RlValues& values() { return values_; }
  const RlValues& values() const { return values_; }
  const RlStatistics& statistics() const { return statistics_; }
  ChoiceGraph& choices() { return choices_; }
  RlTemplates& templates() { return templates_; }
  const Apoptosis& apoptosis() const { return apoptosis_; }

  // Module. Called while learning is on:
  void OperatorChosen(GoalLevel level, std::span<const Candidate> candidates, const Candidate& winner) override;
  void OperatorInstalled(GoalLevel level, Symbol op) override;
  /// A substate is removed: its last update uses only the reward, because no decision follows.
  void StateEnds(GoalLevel level) override;
  /// Ends the episode in all goals.
  void Halted() override;
  // Called while apoptosis is on:
  void MatchEnded(ProductionId rule) override;
  /// Removes learned rules that are not used.
  void OutputEnd() override;
  // Called always:
  void RuleAdded(ProductionId rule, const Production& production) override;
  void RuleExcised(ProductionId rule) override;
  /// Discards the data of goals; learned values stay.
  void AfterInit() override;
  void Mark(const std::function<void(Symbol)>& mark) override;

 private:
  /// The eligibility of a rule: its share in the next update.
  struct Trace {
    ProductionId rule;
    double weight;
  };
  /// The data of a goal.
  struct GoalRecord {
    std::vector<ProductionId> previous;  ///< Rules that supported the last operator: one entry per match.
    std::vector<Trace> traces;           ///< By rule.
    double reward = 0;                   ///< The reward collected since the last update.
    double ratio = 1;  ///< Probability of the last selection under the greedy policy divided by that under exploration.
    std::uint32_t gap = 0;   ///< Number of decisions without learning rules since the last update.
    std::uint32_t held = 0;  ///< Number of decisions below this goal while it waited (hrl_discount).
  };
  /// The future of an operator, as an update needs it.
  struct Future {
    double value = 0;        ///< Value of the next operator; 0 if there is none.
    bool from_rules = true;  ///< A learning rule supports that operator: a gap ends.
    bool expected = true;    ///< False if nothing can follow: the expected part is not updated.
  };
  /// The step size of one update, by the weight of a rule's trace.
  struct Step {
    double current_error = 0, future_error = 0, error = 0;
    bool expected = true;
  };

  GoalRecord& Record(GoalLevel level);
  void Collect(GoalLevel level);
  double RewardOf(Symbol reward_link) const;
  void Update(GoalLevel level, const Future& future);
  /// Decays old traces and adds the rules to be updated.
  void AdvanceTraces(GoalRecord& record, double discount, bool has_substate);
  void Move(const Trace& trace, const Step& step, Symbol& shown);
  double RateOf(RlValue& value, double error) const;
  void CorrectGradient(const Goal& goal, const GoalRecord& record, double trace_product, double previous_product);
  /// Sets the updated numbers in the preferences of the rules changed by this update.
  void ShowInPreferences(Symbol shown);
  /// The value of a candidate, as the sum or mean of its numbers, and whether one of them is from a learning rule.
  Future Judge(const Goal& goal, Symbol value) const;
  /// The learning rule that created a preference, or kNone.
  ProductionId LearningRuleOf(PreferenceId preference) const;
  void Forget(GoalRecord& record);
  void ForgetPrevious(GoalRecord& record);
  /// Whether apoptosis may remove a rule, as far as its learned value is concerned.
  bool IsUnused(ProductionId rule) const;
  void KeepChoice(const Goal& goal, std::span<const Candidate> candidates, const Candidate& winner);
  void Note(GoalRecord& record, ProductionId rule);

  Uses uses_;
  RlSettings settings_;
  RlValues values_;
  RlStatistics statistics_;
  ChoiceGraph choices_;
  RlTemplates templates_;
  Apoptosis apoptosis_;
  std::vector<GoalRecord> goals_;  ///< By level, from 1.
  double chosen_ratio_ = 1;        ///< For the operator that is about to be installed.
  std::uint32_t update_ = 0;       ///< Number of updates; marks the rules that one update changes.
};

}  // namespace soarbox::kernel
