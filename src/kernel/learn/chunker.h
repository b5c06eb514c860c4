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

/// Explanation-based chunking. When a rule in a substate creates a result for a higher state, Chunker explains the
/// result. It generalizes the explanation to a rule that creates the result in one step. If this is not wanted or would
/// be incorrect, and always while learning is off, a justification (justification.h) supports the result instead.
///
/// Each stage has its own file: results, backtrace, identity_analysis, rule_builder (conditions, actions, repair). The
/// rule is added here.
class Chunker final : public Module {
 public:
  /// The parts of the agent that it uses.
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
  /// For `chunk`. Call ModeChanged after changes of `mode` or `automatic_singletons`.
  LearnSettings& mutable_settings() { return settings_; }
  void ModeChanged();
  const LearnStatistics& statistics() const { return statistics_; }
  Singletons& singletons() { return singletons_; }
  const Singletons& singletons() const { return singletons_; }

  /// Called for each instantiation of a substate immediately after it fired. Continues with the next higher state as
  /// long as there are results.
  [[gnu::noinline]] void Consider(InstantiationId id);
  /// A rule fired in a substate while learning is on: its identities are numbered.
  [[gnu::noinline]] void NoteFiring(InstantiationId id);
  /// A firing in a substate copied objects, and its trace contains the elements that it read for that.
  [[gnu::noinline]] void NoteCopied(InstantiationId id, std::span<const RuleContext::Copied> copied);
  void ForgetCopied(InstantiationId id) { reader_.ForgetCopied(id); }
  void ForgetTurned(InstantiationId id) { reader_.ForgetTurned(id); }
  /// Like NoteFiring, for a rule that tests the selected operator of its substate.
  [[gnu::noinline]] void NoteSelection(InstantiationId id);
  /// The number of an identity that no rule created: that of the name of a substate or of its superstate.
  std::uint32_t NumberOfSpecial(IdentityGraph::Key key) const;
  /// The firing of the architecture that created an item.
  struct ItemFiring {
    std::uint32_t serial = 0;
    std::uint32_t identity = 0;  ///< The number of the operator's identity; 0 for none.
  };
  /// Returns null for items that were created while learning was off.
  const ItemFiring* FiringOfItem(WmeId item) const;
  ExplanationLog& explanations() { return log_; }
  const ExplanationLog& explanations() const { return log_; }
  /// (dont-learn <s>) and (force-learn <s>): states that learning excludes, or is limited to.
  void SetLearning(Symbol state, bool learn);
  std::vector<Symbol> forced_states() const { return force_learn_; }
  std::vector<Symbol> excluded_states() const { return dont_learn_; }
  /// The origin of a learned rule: the name of the original rule, and the number of generations since.
  struct Origin {
    std::string base;
    std::uint32_t depth = 0;
  };
  Origin OriginOf(InstantiationId firing) const;
  std::size_t learned_count() const { return learned_.size(); }
  LearnedRules LearnedBySource() const;

  // Module
  void StateMade(GoalLevel level) override;
  /// Each item counts as a firing with its own identities for the state and the operator.
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
  /// Counts the result of Justifier::Build in the statistics: a justification, or none for a duplicate. Returns it.
  InstantiationId CountJustification(InstantiationId made);
  /// Returns true if a rule may be learned from the explanation.
  bool MayLearn() const;
  void CountIdentities(std::uint32_t count);
  /// Reports to observers why nothing is learned from a firing.
  void TellNotLearned(InstantiationId firing, NotLearned why) const;
  /// Returns whether the settings exclude the firing's state, and reports it.
  bool IsLeftOut(InstantiationId firing) const;
  InstantiationId BuildChunk(InstantiationId base, GoalLevel goal_level, bool& failed);
  InstantiationId Enter(InstantiationId base, bool repaired);
  /// A name for a new rule. `counts`: increases the number of rules of this kind in this cycle, which is part of the
  /// name.
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
  std::uint32_t explanation_number_ = 0;  ///< The number of the explanation of the current rule, if it is to be kept.
  bool left_out_ = false;                 ///< The settings exclude the state of the current firing.
  std::uint32_t next_identity_ = 1;
  std::uint32_t next_number_ = 0;  ///< For numbered names.
  std::vector<std::uint32_t>
      substate_identity_;  ///< By level: the identity number of the state's name; that of its superstate follows.
  std::unordered_map<WmeId, ItemFiring> item_firings_;  ///< Items of the existing substates, including removed ones.
  ItemFiring first_item_;                               ///< The first item of the last ItemsMade.
  std::uint64_t cycle_ = ~std::uint64_t{0};
  std::uint32_t rules_in_cycle_ = 0, justifications_in_cycle_ = 0;
  std::unordered_map<ProductionId, Origin> learned_;
};

}  // namespace soarbox::kernel
