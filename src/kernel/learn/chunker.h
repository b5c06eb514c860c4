// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/module.h"
#include "kernel/learn/backtrace.h"
#include "kernel/learn/carried_tests.h"
#include "kernel/learn/explanation.h"
#include "kernel/learn/explanation_log.h"
#include "kernel/learn/firing_reader.h"
#include "kernel/learn/identity_analysis.h"
#include "kernel/learn/justification_plan.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/learn/results.h"
#include "kernel/learn/rule_builder.h"
#include "kernel/learn/singletons.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

class Agent;
struct AgentCounters;
struct AgentSettings;
class Descriptions;
class ExpectedValues;
class Firing;
class GoalChanges;
class GoalStack;
class InstantiationTable;
class Justifier;
class Modules;
class Observers;
class PreferenceChanges;
class ProductionRecord;
class Rete;
class RuleChanges;
class RunControl;
class SelectionKnowledge;
class SymbolTable;
class WmeChanges;
class WorkingMemory;

/// Explanation-based chunking: when a rule in a substate gives something to a higher state, this explains why, and
/// turns the explanation into a rule that does in one step what the substate did. Where that is not wanted or not
/// right, and always while learning is off, the result gets a justification instead (justification.h), which supports
/// it.
///
/// The stages, each with a file of its own: results, backtrace, identity_analysis, rule_builder (conditions, actions,
/// repair), and entering the rule here.
class Chunker final : public Module {
 public:
  /// What it uses of the agent.
  struct Uses {
    Agent& agent;
    SymbolTable& symbols;
    WorkingMemory& memory;
    GoalStack& goals;
    InstantiationTable& instantiations;
    Rete& rete;
    const std::vector<ProductionRecord>& productions;
    WmeChanges& changes;
    PreferenceChanges& preferences;
    const GoalChanges& goal_changes;
    Firing& firing;
    RunControl& run;
    SelectionKnowledge& selections;
    Justifier& justifier;
    const Descriptions& descriptions;
    const AgentSettings& settings;
    AgentCounters& counters;
    const ExpectedValues& expected_values;
    const Observers& observers;
    RuleChanges& rule_changes;
    Modules& modules;
  };
  explicit Chunker(const Uses& uses);
  ~Chunker() override;

  const LearnSettings& settings() const { return settings_; }
  /// For `chunk`. Call ModeChanged after `mode` or `automatic_singletons` changed.
  LearnSettings& mutable_settings() { return settings_; }
  void ModeChanged();
  const LearnStatistics& statistics() const { return statistics_; }
  LearnStatistics& mutable_statistics() { return statistics_; }
  Singletons& singletons() { return singletons_; }
  const Singletons& singletons() const { return singletons_; }

  /// Called for each instantiation of a substate right after it fired; goes on upwards as long as there are results.
  [[gnu::noinline]] void Consider(InstantiationId id);
  /// A rule fired in a substate, and learning is on: its identities begin.
  [[gnu::noinline]] void NoteFiring(InstantiationId id);
  /// A firing in a substate copied objects, and its trace has what it read.
  [[gnu::noinline]] void NoteCopied(InstantiationId id, std::span<const RuleContext::Copied> copied);
  void ForgetCopied(InstantiationId id) { reader_.ForgetCopied(id); }
  void ForgetTurned(InstantiationId id) { reader_.ForgetTurned(id); }
  /// The same for a rule that tests the selected operator of its substate.
  [[gnu::noinline]] void NoteSelection(InstantiationId id);
  /// The number of an identity that is no rule's: the name of a substate or of its superstate.
  std::uint32_t NumberOfSpecial(IdentityGraph::Key key) const;
  /// The firing behind an item.
  struct ItemFiring {
    std::uint32_t serial = 0;
    std::uint32_t identity = 0;  ///< The number of the operator's; 0 for none.
  };
  /// Null for items that came while nothing was to be learned.
  const ItemFiring* FiringOfItem(WmeId item) const;
  ExplanationLog& explanations() { return log_; }
  const ExplanationLog& explanations() const { return log_; }
  /// (dont-learn <s>) and (force-learn <s>): states that learning leaves out, or is limited to.
  void SetLearning(Symbol state, bool learn);
  std::vector<Symbol> forced_states() const { return force_learn_; }
  std::vector<Symbol> excluded_states() const { return dont_learn_; }
  /// What a learned rule was learned from: the name of the first rule, and how often rules were learned from rules.
  struct Origin {
    std::string base;
    std::uint32_t depth = 0;
  };
  Origin OriginOf(InstantiationId firing) const;
  std::size_t learned_count() const { return learned_.size(); }
  LearnedRules LearnedBySource() const;

  // Module
  void StateMade(GoalLevel level) override;
  /// Each item stands for a firing that names its state and its operator.
  void ItemsMade(std::uint32_t firings) override;
  void ItemMade(WmeId item, std::uint32_t index) override;
  void StateRemoved(GoalLevel level) override;
  /// For singletons.
  void AttributeUsed(Symbol attribute) override { singletons_.Note(attribute); }
  void RuleExcised(ProductionId rule) override;
  void AfterInit() override;
  void Mark(const std::function<void(Symbol)>& mark) override;
  std::size_t MemoryBytes() const override { return log_.MemoryBytes(); }

 private:
  void AskForHooks();
  InstantiationId Learn(InstantiationId base);
  /// `made`: none if it was a duplicate.
  InstantiationId CountJustification(InstantiationId made);
  /// True if a rule may be learned from the explanation.
  bool MayLearn() const;
  void CountIdentities(std::uint32_t count);
  /// Says why nothing is learned from a firing, to those who want to know.
  void TellNotLearned(InstantiationId firing, NotLearned why) const;
  /// Whether the settings leave the firing's state out; says so.
  bool IsLeftOut(InstantiationId firing) const;
  InstantiationId BuildChunk(InstantiationId base, GoalLevel goal_level, bool& failed);
  InstantiationId Enter(InstantiationId base, bool repaired);
  /// `counts`: it is one more of its kind in this cycle.
  std::string NewName(InstantiationId base, bool is_chunk, bool counts);
  void Tell(const std::string& name);
  void BeginCycle();
  void Interrupt(const std::string& reason);

  Uses uses_;
  LearnSettings settings_;
  LearnStatistics statistics_;
  Singletons singletons_;
  FiringReader reader_;
  ResultCollector results_;
  Backtracer backtracer_;
  IdentityAnalysis analysis_;
  CarriedTests carried_;
  RuleBuilder builder_;
  JustificationPlanner planner_;
  ExplanationLog log_;
  Explanation explanation_;
  std::vector<Symbol> dont_learn_, force_learn_;
  bool notes_elements_ = false;
  std::uint32_t explanation_number_ = 0;  ///< Of what is being learned, if it is to be kept.
  bool left_out_ = false;                 ///< The state of the firing that is considered.
  std::uint32_t next_identity_ = 1;
  std::uint32_t next_number_ = 0;  ///< Of numbered names.
  std::vector<std::uint32_t>
      substate_identity_;  ///< By level: the number of the state's name; its superstate's follows.
  std::unordered_map<WmeId, ItemFiring> item_firings_;  ///< Of the substates that there are, also of items that left.
  ItemFiring first_item_;                               ///< Of those that ItemsMade told of last.
  std::uint64_t cycle_ = ~std::uint64_t{0};
  std::uint32_t rules_in_cycle_ = 0, justifications_in_cycle_ = 0;
  std::unordered_map<ProductionId, Origin> learned_;
};

}  // namespace soarbox::kernel
