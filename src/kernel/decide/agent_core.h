// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "kernel/agent.h"
#include "kernel/base/random.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/agent_rules.h"
#include "kernel/decide/agent_settings.h"
#include "kernel/decide/decision.h"
#include "kernel/decide/descriptions.h"
#include "kernel/decide/elaboration.h"
#include "kernel/decide/element_events.h"
#include "kernel/decide/exploration.h"
#include "kernel/decide/firing.h"
#include "kernel/decide/goal_changes.h"
#include "kernel/decide/goal_dependency_set.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/modules.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/decide/preference_semantics.h"
#include "kernel/decide/production_record.h"
#include "kernel/decide/rule_context.h"
#include "kernel/decide/rule_directory.h"
#include "kernel/decide/run_control.h"
#include "kernel/decide/slot_decision.h"
#include "kernel/io/input_link.h"
#include "kernel/io/output_link.h"
#include "kernel/learn/chunker.h"
#include "kernel/learn/justification.h"
#include "kernel/learn/reinforcement.h"
#include "kernel/learn/selection_knowledge.h"
#include "kernel/longterm/long_term.h"
#include "kernel/match/rete.h"
#include "kernel/memory/links.h"
#include "kernel/memory/output_marks.h"
#include "kernel/memory/wme_changes.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

class Imagery;

/// All parts of one agent. The parts access each other through this struct; each part's header documents it. Not
/// visible outside the kernel: Agent is the public interface.
struct AgentCore {
  AgentCore(Agent& owner, std::string agent_name);
  ~AgentCore();

  Agent& agent;
  std::string name;

  // Data.
  SymbolTable symbols;
  WorkingMemory memory;
  LinkGraph links;
  OutputMarks output_marks;
  InstantiationTable instantiations;
  GoalStack goals;
  Rete rete;

  AgentSettings settings;
  AgentCounters counters;
  ExplorationSettings exploration;
  ExpectedValues expected_values;
  RandomStream random;
  Observers observers;

  std::vector<ProductionRecord> productions;
  RuleDirectory rules;
  AgentRules rule_changes;
  std::map<ProductionId, std::uint32_t> interrupts;  ///< How often each rule has interrupted a run.
  std::size_t learned_rule_bytes = 0;                ///< Approximate memory of the rules added while the agent ran.
  bool rules_changed = false;  ///< The rules have changed since they were last offered for sharing.

  // The parts that act, in the order of the cycle.
  Modules modules;
  ElementEvents element_events;
  WmeChanges changes;
  InputLink input;
  OutputLink output;
  PreferenceChanges preferences;
  RuleContext context;
  Firing firing;
  SelectionKnowledge selections;
  Chunker chunker;
  Justifier justifier;
  Reinforcement reinforcement;
  Descriptions descriptions;
  SlotDecision slot_decision;
  GoalDependencySets gds;
  GoalChanges goal_changes;
  PreferenceSemantics semantics;
  Decision decision;
  Elaboration elaboration;
  RunControl run;
  LongTerm long_term;
  std::unique_ptr<Imagery> imagery;  ///< Null until it is first used.

  // Settings and functions of the host.
  std::function<Result<Symbol>(Agent&, std::string_view, std::span<const Symbol>)> user_functions;
  std::function<bool(std::string_view)> is_user_function;
  std::function<std::string(Agent&, std::string_view)> command_runner;
  bool agent_writes = true;
  std::string forced_operator;

  // Sweeping of symbols and identifiers. No sweep takes place below these numbers.
  static constexpr std::size_t kLeastIdentifiersSwept = 1024, kLeastConstantsSwept = 1024;
  std::size_t sweep_identifiers_at = kLeastIdentifiersSwept;
  std::size_t sweep_constants_at = kLeastConstantsSwept;
  std::vector<std::uint8_t> identifier_marks;

  /// Rules that leave the network at the end of the elaboration, not before, so that no firing loses its rule.
  std::vector<ProductionId> excisions;

  /// Shares the rules with agents that have equal rules. Must be called before the agent creates constants that no rule
  /// mentions.
  [[gnu::noinline]] void OfferRules();
  /// The string symbol of a rule's name. It lives as long as the agent.
  Symbol NameOf(const Production& rule);

  /// Call it between decision cycles. Frees unused constants and identifiers when their number has doubled since the
  /// last sweep. If the last sweep freed less than half of them, waits until it has quadrupled.
  void SweepSymbols() {
    if (memory.identifier_count() >= sweep_identifiers_at || symbols.UnpinnedCount() >= sweep_constants_at) Sweep();
  }
  [[gnu::noinline]] void Sweep();
  /// Removes everything except the rules, and creates the first state. Reports it to observers if `announce` is set.
  void Initialize(bool announce);
  /// Throws std::bad_alloc, which aborts the current run, if the agent has exceeded AgentSettings::most_memory_bytes.
  void StopIfOutgrown() const;
  /// In builds with SOARBOX_CHECK_INVARIANTS, checks that the parts are consistent; aborts with the reason if not.
  void CheckAfterPhase() const;
  /// In such builds, aborts unless the top state already has a preference for the same value as `left_out`.
  void CheckSupported(const Preference& left_out) const;
};

}  // namespace soarbox::kernel
