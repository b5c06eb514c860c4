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

/// What `rl --stats` shows.
struct RlStatistics {
  double reward = 0;        ///< Of the last decision that collected any.
  double total_reward = 0;  ///< Since init-soar.
};

/// Reinforcement learning: moves the numbers of rules whose only action is a numeric preference for an operator.
///
/// When an operator is chosen in a goal, the reward of all goals is collected, and the rules that spoke for the
/// goal's previous operator move towards reward plus the discounted value of the new one. Then the rules that speak for
/// the new one are noted. Reward is what (reward-link ^reward.value) says: numbers, all summed.
///
/// Belongs to one agent; shared rules and networks are only read.
class Reinforcement final : public Module {
 public:
  /// What it uses of the agent.
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
  /// Switching learning off forgets what was noted for the next update; values stay.
  void Set(const RlSettings& settings);

  RlValues& values() { return values_; }
  const RlValues& values() const { return values_; }
  const RlStatistics& statistics() const { return statistics_; }
  ChoiceGraph& choices() { return choices_; }
  RlTemplates& templates() { return templates_; }
  const Apoptosis& apoptosis() const { return apoptosis_; }

  // Module. While learning is on:
  void OperatorChosen(GoalLevel level, std::span<const Candidate> candidates, const Candidate& winner) override;
  void OperatorInstalled(GoalLevel level, Symbol op) override;
  /// Nothing follows in a substate that goes, so only its reward counts.
  void StateEnds(GoalLevel level) override;
  /// The episode ends in all goals.
  void Halted() override;
  // While apoptosis is on:
  void MatchEnded(ProductionId rule) override;
  /// Learned rules that nobody uses go.
  void OutputEnd() override;
  // Always:
  void RuleAdded(ProductionId rule, const Production& production) override;
  void RuleExcised(ProductionId rule) override;
  /// Goals are forgotten, values stay.
  void AfterInit() override;
  void Mark(const std::function<void(Symbol)>& mark) override;

 private:
  /// How much a rule shares in the next update.
  struct Trace {
    ProductionId rule;
    double weight;
  };
  /// What learning keeps for a goal.
  struct GoalRecord {
    std::vector<ProductionId> previous;  ///< Rules that spoke for the last operator: one entry for each match.
    std::vector<Trace> traces;           ///< By rule.
    double reward = 0;                   ///< Collected since the last update.
    double ratio = 1;                    ///< Chance of the last choice when greedy, by its chance as explored.
    std::uint32_t gap = 0;               ///< Decisions without such rules since the last update.
    std::uint32_t held = 0;              ///< Decisions below while this goal waited (hrl_discount).
  };
  /// What follows an operator, as an update sees it.
  struct Future {
    double value = 0;        ///< Of the next operator; 0 if there is none.
    bool from_rules = true;  ///< A rule speaks for that operator: a gap ends.
    bool expected = true;    ///< False where nothing can follow: the expected part is left as it is.
  };
  /// How much one update moves every rule that has a trace, by the weight of that.
  struct Step {
    double current_error = 0, future_error = 0, error = 0;
    bool expected = true;
  };

  GoalRecord& Record(GoalLevel level);
  void Collect(GoalLevel level);
  double RewardOf(Symbol reward_link) const;
  void Update(GoalLevel level, const Future& future);
  /// Lets old traces fade and adds the rules to be updated.
  void AdvanceTraces(GoalRecord& record, double discount, bool has_substate);
  void Move(const Trace& trace, const Step& step, Symbol& shown);
  double RateOf(RlValue& value, double error) const;
  void CorrectGradient(const Goal& goal, const GoalRecord& record, double trace_product, double previous_product);
  /// Gives the preferences of the rules that moved in this update their number.
  void ShowInPreferences(Symbol shown);
  /// The value of a candidate as the sum or mean of its numbers, and whether a learning rule gave one of them.
  Future Judge(const Goal& goal, Symbol value) const;
  /// The rule of this kind that made a preference, or kNone.
  ProductionId LearningRuleOf(PreferenceId preference) const;
  void Forget(GoalRecord& record);
  void ForgetPrevious(GoalRecord& record);
  /// Whether apoptosis may take a rule, as far as learning goes.
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
  double chosen_ratio_ = 1;        ///< Of the operator that is about to be installed.
  std::uint32_t update_ = 0;       ///< Counts updates, to mark the rules that one moves.
};

}  // namespace soarbox::kernel
