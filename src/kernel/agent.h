// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "diagnostics/result.h"
#include "kernel/base/ids.h"
#include "kernel/base/random.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/agent_settings.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation.h"
#include "kernel/io/input_link.h"
#include "kernel/io/output_link.h"
#include "kernel/match/rete.h"
#include "kernel/match/wme.h"
#include "kernel/memory/working_memory.h"
#include "kernel/observer.h"
#include "kernel/rules/parser.h"
#include "kernel/rules/production.h"

/// The public interface of the kernel. Other modules include this header, and the headers of the parts that Agent
/// returns for reading.
namespace soarbox::kernel {

struct AgentCore;
struct ExplorationSettings;
class LongTerm;
class ChoiceGraph;
struct RlSettings;
struct RlStatistics;
struct RlValue;
class ExplanationLog;
struct LearnSettings;
struct LearnedRules;
struct LearnStatistics;
class Imagery;
class Singletons;

enum class RunUnit : std::uint8_t { kElaboration, kPhase, kDecision, kOutput, kForever };
enum class StopReason : std::uint8_t { kCompleted, kInterrupted, kHalted, kLimit };

struct RunResult {
  StopReason reason = StopReason::kCompleted;
  std::uint64_t decisions = 0;  ///< Decision cycles (output phases) completed by this run.
  std::uint64_t elaborations = 0;
  std::uint64_t firings = 0;
};

/// The result of loading one rule.
struct LoadOutcome {
  bool loaded = false;
  ProductionId production = ProductionId::kNone;  ///< The rule, if loaded.
  std::string name;                               ///< Empty if the name could not be read.
  /// The texts that Soar prints while it reads the rule: those before the "#" for an excised older rule, and those
  /// after it.
  std::vector<RuleMessage> printed, printed_late;
  bool replaced = false;             ///< A rule of the same name was excised first ("#").
  std::string duplicate_of;          ///< "Ignoring X because it is a duplicate of Y".
  std::vector<Diagnostic> messages;  ///< Our own diagnostics, with places and hints, in the order of the text.
};

/// One Soar agent. Agents share no mutable state: different agents may run on different threads at the same time. One
/// agent is used by one thread at a time. Only RequestStop() may be called from any thread.
///
/// While the agent runs, calls that change it (from an observer or a right-hand-side function) are refused. Exceptions:
/// RequestStop() and the buffering calls of the input link. Loading and excising are also accepted: a loaded rule is
/// matched immediately, an excised one leaves the match at the end of the elaboration.
class Agent {
 public:
  explicit Agent(std::string name);
  ~Agent();
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  const std::string& name() const;

  // Rules -----------------------------------------------------------------------------------------------------------

  /// Loads one rule. `body` is the text between the braces of sp {...}. Excises an existing rule of the same name
  /// first, even if the new one has an error.
  LoadOutcome LoadProduction(std::string_view body, const SourcePlace& place = {});
  /// Loads a rule that was built with this agent's symbols, not read from text. With `ignore_number`, a rule of
  /// reinforcement learning is a duplicate if it differs from a loaded one only in its number, whatever
  /// AgentSettings::ignore_numbers_of_duplicates is.
  LoadOutcome AddProduction(ProductionPtr production, bool ignore_number = false);
  /// Removes the rule, and everything that only its matches support.
  void Excise(ProductionId production);
  ProductionId FindProduction(std::string_view name) const;  ///< kNone if there is none.
  const Production& production(ProductionId id) const;
  const ProductionPtr& production_ptr(ProductionId id) const;
  /// The rule with the number that reinforcement learning computed for it, for printing and saving. Returns the
  /// original rule if no number was learned.
  ProductionPtr ProductionAsLearned(ProductionId id) const;
  /// The values that reinforcement learning stores for a rule (learn/rl_values.h); null if it has not used the rule
  /// yet.
  const RlValue* LearnedValue(ProductionId id) const;
  /// All rules in loading order, oldest first (`print` lists them newest first).
  std::vector<ProductionId> Productions() const;
  std::uint32_t CountProductions(ProductionType type) const;
  std::uint64_t FiringCount(ProductionId id) const;
  void ResetFiringCounts();
  /// `production break`: interrupts the run when the rule fires, like :interrupt. `on` = false also disables the rule's
  /// own :interrupt.
  void SetBreak(ProductionId id, bool on);
  bool HasBreak(ProductionId id) const;

  // Running ---------------------------------------------------------------------------------------------------------

  /// Runs `count` units (`count` is ignored for kForever). A run of kDecision ends before settings().stop_phase.
  RunResult Run(RunUnit unit, std::uint64_t count = 1);
  /// Runs one unit, for schedulers that interleave agents. Returns early if the agent halts or is asked to stop.
  /// kElaboration: one elaboration, or one phase if the phase has none. kPhase: to the end of the current phase.
  /// kDecision: to the end of the output phase. kOutput: to the end of an output phase that changed the output link, or
  /// until max_nil_output_cycles output phases have passed without a change. kForever: until something else stops the
  /// run.
  /// With kDecision: if further decisions would change nothing without new input, the agent does not execute them. The
  /// remaining decisions, up to `most` in total, are only counted.
  RunResult Step(RunUnit unit, std::uint64_t most = 1);
  /// Runs phase by phase until `phase` is next. Does nothing if `phase` is next already.
  RunResult RunToPhase(Phase phase);
  /// The current phase if the agent is in the middle of one, else the phase that runs next.
  Phase next_phase() const;
  /// True between two elaborations of the same phase.
  bool in_middle_of_phase() const;
  /// Asks the agent to stop at the next boundary (phase or elaboration). Callable from any thread. The request lasts
  /// until it has ended a run, or until ClearStopRequest(), which run commands call before they start.
  void RequestStop(std::string_view reason = {});
  void ClearStopRequest();
  bool halted() const;   ///< A rule executed (halt): Run and Step do nothing until InitSoar.
  bool running() const;  ///< True during Run and Step.
  /// The name of the rule whose actions are being executed, for observers; empty if there is none.
  std::string_view FiringRule() const;
  /// The name of the rule that fires next. If no rule waits to fire, that of the next retraction; empty if there is
  /// none.
  std::string_view NextRule() const;
  /// True after memory ran out while the agent ran or loaded a rule. The agent is then halted for good. It can only be
  /// read and destroyed; calls that would change it are refused.
  bool out_of_memory() const;
  /// The cause of the memory exhaustion if it could be determined: "rule p had 5000000 partial matches". Else empty.
  std::string_view breakdown() const;
  /// The run ends when this goal is removed (`run -g`). The none symbol: no goal is watched.
  void SetGoalToWatch(Symbol goal);
  /// Empties working memory and creates the first state again. Keeps all rules except justifications. Refused while the
  /// agent runs.
  void InitSoar();

  // Settings --------------------------------------------------------------------------------------------------------

  const AgentSettings& settings() const;
  AgentSettings& mutable_settings();
  const ExplorationSettings& exploration() const;  ///< decide/exploration.h
  ExplorationSettings& mutable_exploration();
  /// Applies to rules loaded afterwards. Its symbols must be pinned.
  const ExpectedValues& expected_values() const;
  ExpectedValues& mutable_expected_values();
  /// learn/rl_settings.h
  const RlSettings& reinforcement() const;
  void SetReinforcement(const RlSettings& settings);
  /// learn/reinforcement.h
  const RlStatistics& reward() const;
  ChoiceGraph& choice_graph();  ///< learn/choice_graph.h
  RandomStream& random();
  /// `decide select`: the operator to select at the next decision of its goal, if it is proposed then. Empty: none.
  void SelectOperator(std::string_view identifier);
  std::string_view selected_operator() const;
  /// `decide predict`: the result of the next decide phase: an operator's identifier, "none", "tie", "conflict" or
  /// "constraint".
  std::string PredictDecision();
  /// Enables the output of (write ...) and (crlf) (`output agent-writes`).
  void SetAgentWrites(bool on);

  // Learning --------------------------------------------------------------------------------------------------------

  const LearnSettings& learning() const;  ///< learn/learn_settings.h
  /// Calls `change` with the settings, and puts the changed settings into effect.
  void ChangeLearning(const std::function<void(LearnSettings&)>& change);
  const LearnStatistics& learn_statistics() const;
  std::size_t learned_rule_count() const;
  LearnedRules LearnedBySource() const;
  /// Number of instantiations since init-soar: firings of rules in all states, and attempts to learn a rule.
  std::uint32_t instantiation_count() const;
  const Singletons& singletons() const;  ///< learn/singletons.h
  Singletons& mutable_singletons();
  /// How rules were learned. The log has settings that select which explanations are kept (learn/explanation_log.h).
  const ExplanationLog& explanations() const;
  ExplanationLog& mutable_explanations();
  /// The states that rules named in (force-learn <s>). StatesNotToLearn returns those named in (dont-learn <s>).
  std::vector<Symbol> StatesForcedToLearn() const;
  std::vector<Symbol> StatesNotToLearn() const;

  // Observing -------------------------------------------------------------------------------------------------------

  /// Adds an observer, or changes its mask if it is registered already. Not owned: remove it before it is destroyed.
  void AddObserver(Observer& observer, EventMask events);
  void RemoveObserver(Observer& observer);
  /// The union of the masks of all observers.
  EventMask observed() const;

  // Inspecting ------------------------------------------------------------------------------------------------------

  const SymbolTable& symbols() const;
  /// For interning the symbols that a command mentions.
  SymbolTable& mutable_symbols();
  const WorkingMemory& memory() const;
  const GoalStack& goals() const;
  const Rete& rete() const;
  const AgentCounters& counters() const;
  std::string_view ProductionName(InstantiationId id) const;  ///< Includes justifications ("justify1").
  /// The elements matched by the positive conditions of an instantiation, in the order of the conditions. Empty if it
  /// no longer matches.
  std::span<const WmeId> MatchedWmes(InstantiationId id) const;
  /// The live justifications, oldest first, as rules with literal conditions (`print --justifications`).
  std::vector<ProductionPtr> Justifications() const;
  /// The justification that produced this instantiation, as a rule; null if none did.
  ProductionPtr JustificationOf(InstantiationId id) const;
  /// Returns false if there is no justification of this name, or if the agent is running.
  bool ExciseJustification(std::string_view name);
  WmeInfo Describe(WmeId id) const;
  GoalInfo Describe(const Goal& goal) const;
  /// The operator selected in a goal, or the none symbol.
  Symbol OperatorOf(const Goal& goal) const;
  /// The preferences of one type in a slot, in list order.
  std::vector<PreferenceId> PreferencesOf(SlotId slot, PreferenceType type) const;
  /// The candidates of a goal's operator slot with their selection probabilities under the current exploration policy,
  /// in candidate order. Empty if the decision would be an impasse or there is no candidate.
  struct CandidateChance {
    PreferenceId preference = PreferenceId::kNone;
    Symbol value;
    double numeric_value = 0;
    double probability = 0;
  };
  std::vector<CandidateChance> SelectionProbabilities(const Goal& goal) const;
  /// Evaluates the preferences that are in the goal's operator slot now: which candidates are dropped, at which stage,
  /// and why (decide/decision_trace.h). Draws no random numbers. Valid until the agent runs, or until this function,
  /// SelectionProbabilities or PredictDecision is called.
  DecisionReport ExplainDecision(const Goal& goal) const;

  // Input and output ------------------------------------------------------------------------------------------------

  InputLink& input();
  const InputLink& input() const;
  const OutputLink& output() const;
  Symbol InputLinkIdentifier() const;
  Symbol OutputLinkIdentifier() const;
  /// `wm add`: adds an input element to any identifier immediately. Refused while the agent runs.
  Result<WmeId> AddWme(Symbol id, Symbol attribute, Symbol value, bool acceptable = false);
  /// Creates an identifier for `wm add` with the value `*`.
  Symbol NewIdentifier(char letter);
  /// Creates an identifier with a given name on the level of `parent`. The name must be unused, and `parent` must be in
  /// working memory.
  Symbol NewIdentifier(char letter, std::uint64_t number, Symbol parent);
  /// `wm remove`: removes any element immediately. Preferences stay. So an element that a rule created is added again
  /// when another preference enters or leaves its slot. An operator whose proposal is removed stays selected.
  Result<void> RemoveWme(WmeId wme);

  /// Functions of the host that rules call with (exec name ...) or (name ...). The argument is the concatenation of the
  /// rule's arguments without separators. The result is a symbol, or the none symbol for no value. If the function
  /// returns an error, the action is skipped and the error is printed. The function runs on the agent's thread in the
  /// middle of a phase; it must not run, initialize or change the agent.
  /// `is_there` returns whether a function of this name exists. Rules may call such a function without `exec`.
  void SetUserFunctions(std::function<Result<Symbol>(Agent&, std::string_view name, std::span<const Symbol>)> function,
                        std::function<bool(std::string_view name)> is_there = {});
  /// `runner` executes a command line for (cmd ...) and returns its output.
  void SetCommandRunner(std::function<std::string(Agent&, std::string_view line)> runner);

  /// Long-term memory: semantic and episodic memory, activation of working memory (longterm/long_term.h).
  LongTerm& long_term();
  const LongTerm& long_term() const;

  /// The spatial visual system (imagery/imagery.h); created at the first call.
  Imagery& imagery();
  /// Like imagery(), but null if it has not been created.
  const Imagery* find_imagery() const;

  // Memory ----------------------------------------------------------------------------------------------------------

  std::size_t MemoryBytes() const;        ///< This agent's own memory, including the rules that it learned.
  std::size_t SharedMemoryBytes() const;  ///< Rules and network that agents with equal rules share.
  /// Checks the invariants of support, links, slots and matches. Returns a description of the first violation, or an
  /// empty text. Slow: walks all data.
  std::string CheckInvariants() const;

 private:
  /// Excises the rule of this name, if there is one.
  void ExciseNamed(std::string_view name, LoadOutcome& outcome);
  /// Adds a rule; its name must be unused.
  void Enter(ProductionPtr production, LoadOutcome& outcome, bool ignore_number);

  /// Returns false if memory ran out during `work`.
  template <typename Work>
  bool Guarded(Work work);
  void PrepareMatch();
  template <typename Work>
  RunResult RunGuarded(Work work);
  /// Halts the agent for good and reports it. `rule`: the rule whose addition exhausted the memory, if it was one.
  void BreakDown(std::string_view rule = {});
  void Replace(ProductionPtr production, LoadOutcome& outcome, bool ignore_number);

  std::unique_ptr<AgentCore> core_;
  std::string breakdown_;
};

}  // namespace soarbox::kernel
