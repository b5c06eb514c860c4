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

/// The face of the library. cli/ and sml/ use this header (and the headers of the parts that it hands out for
/// reading); nothing else of the program includes kernel/ at all.
namespace soarbox::kernel {

struct Engine;
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

/// What became of a rule's text.
struct LoadOutcome {
  bool loaded = false;
  ProductionId production = ProductionId::kNone;  ///< The rule, if loaded.
  std::string name;                               ///< As far as it could be read.
  /// What Soar prints while it reads the rule, before and after it tells ("#") that an older one was excised.
  std::vector<RuleMessage> printed, printed_late;
  bool replaced = false;             ///< A rule of that name was excised first ("#").
  std::string duplicate_of;          ///< "Ignoring X because it is a duplicate of Y".
  std::vector<Diagnostic> messages;  ///< Our own diagnostics: places and hints, in the order of the text.
};

/// One Soar agent. Agents share nothing that changes: different agents may run on different threads at the same time;
/// one agent is used by one thread at a time. Only RequestStop() may be called from any thread.
///
/// Calls that change the agent while it runs (from an observer or a RHS function) are refused, except RequestStop() and
/// the input link's buffering calls; loading and excising are put off until the end of the phase.
class Agent {
 public:
  explicit Agent(std::string name);
  ~Agent();
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  const std::string& name() const;

  // Rules -----------------------------------------------------------------------------------------------------------

  /// Loads one rule: `body` is what stands between the braces of sp {...}. A rule with the same name is excised first.
  LoadOutcome LoadProduction(std::string_view body, const SourcePlace& place = {});
  /// Loads a rule that was built elsewhere with this agent's symbols.
  /// `ignore_number`: a rule of reinforcement learning that differs in its number only is a duplicate, whatever is set.
  LoadOutcome AddProduction(ProductionPtr production, bool ignore_number = false);
  /// Removes the rule and everything that its matches support.
  void Excise(ProductionId production);
  ProductionId FindProduction(std::string_view name) const;  ///< kNone if there is none.
  const Production& production(ProductionId id) const;
  const ProductionPtr& production_ptr(ProductionId id) const;
  /// The rule with the number that reinforcement learning gave it, for printing and saving; the rule itself if it has
  /// learned none.
  ProductionPtr ProductionAsLearned(ProductionId id) const;
  /// What reinforcement learning knows about a rule (learn/rl_values.h); null if it has not used the rule yet.
  const RlValue* LearnedValue(ProductionId id) const;
  /// All rules in loading order, oldest first (`print` lists them the other way round).
  std::vector<ProductionId> Productions() const;
  std::uint32_t CountProductions(ProductionType type) const;
  std::uint64_t FiringCount(ProductionId id) const;
  void ResetFiringCounts();
  /// `production break`: the run is interrupted when the rule fires, as with :interrupt. Turning it off
  /// silences the rule's own :interrupt too.
  void SetBreak(ProductionId id, bool on);
  bool HasBreak(ProductionId id) const;

  // Running ---------------------------------------------------------------------------------------------------------

  /// Runs this agent. For kDecision the run goes on to settings().stop_phase. `count` is ignored for kForever.
  RunResult Run(RunUnit unit, std::uint64_t count = 1);
  /// The finer steps, for schedulers that interleave agents. Each stops early when the agent halts or is asked to stop.
  /// kElaboration: one elaboration, or one phase if the phase has none. kPhase: to the end of the current phase.
  /// kDecision: to the end of the output phase. kOutput: to the end of an output phase that changed the output link, or
  /// until max_nil_output_cycles output phases have passed without one. kForever is not a step.
  /// `most`: if the agent comes to rest in a step of kDecision, so that further ones would come to nothing without new
  /// input, they are counted as made, as many as make that number with the first.
  RunResult Step(RunUnit unit, std::uint64_t most = 1);
  /// Runs phase by phase until `phase` is next. Does nothing if it is.
  RunResult RunToPhase(Phase phase);
  /// The phase that runs next, or that the agent stands in the middle of.
  Phase next_phase() const;
  /// True between two elaborations of a phase that has begun and not ended.
  bool in_middle_of_phase() const;
  /// Asks the agent to stop at the next boundary (phase or elaboration). From any thread. The request is taken back by
  /// ClearStopRequest(), which a run command calls first.
  void RequestStop(std::string_view reason = {});
  void ClearStopRequest();
  bool halted() const;   ///< (halt) ran: Run and Step do nothing until InitSoar.
  bool running() const;  ///< In the middle of Run or Step.
  /// The name of the rule whose actions run now, for observers; empty if none does.
  std::string_view FiringRule() const;
  /// The rule that fires next, of the lowest state in which one does, else one to be retracted; empty if there is none.
  std::string_view NextRule() const;
  /// Memory ran out while the agent ran or loaded a rule, and it said so. It is halted and can only be read and
  /// destroyed: whatever would change it is refused.
  bool out_of_memory() const;
  /// What used the memory up, as far as that can be told: "rule p had 5000000 partial matches". Empty before.
  std::string_view breakdown() const;
  /// A goal whose removal ends the run (`run -g`); the none symbol for none.
  void SetGoalToWatch(Symbol goal);
  /// Empties working memory and starts again with the first state; keeps all rules except justifications. Refused
  /// while running.
  void InitSoar();

  // Settings --------------------------------------------------------------------------------------------------------

  const AgentSettings& settings() const;
  AgentSettings& mutable_settings();
  const ExplorationSettings& exploration() const;  ///< decide/exploration.h
  ExplorationSettings& mutable_exploration();
  /// For rules that are loaded from now on. Its symbols must be pinned.
  const ExpectedValues& expected_values() const;
  ExpectedValues& mutable_expected_values();
  /// learn/rl_settings.h
  const RlSettings& reinforcement() const;
  void SetReinforcement(const RlSettings& settings);
  /// learn/reinforcement.h
  const RlStatistics& reward() const;
  ChoiceGraph& choice_graph();  ///< learn/choice_graph.h
  RandomStream& random();
  /// `decide select`: the operator to select at the next decision of its goal, if it is proposed. Empty: none.
  void SelectOperator(std::string_view identifier);
  std::string_view selected_operator() const;
  /// `decide predict`: what the next decide phase would do: an operator's name, "none", "tie", "conflict",
  /// "constraint".
  std::string PredictDecision();
  /// Whether (write ...) and (crlf) print (`output agent-writes`).
  void SetAgentWrites(bool on);

  // Learning --------------------------------------------------------------------------------------------------------

  const LearnSettings& learning() const;  ///< learn/learn_settings.h
  /// Changes the settings by `change`.
  void ChangeLearning(const std::function<void(LearnSettings&)>& change);
  const LearnStatistics& learn_statistics() const;
  std::size_t learned_rule_count() const;
  LearnedRules LearnedBySource() const;
  /// How many rules fired, in all states, with attempts to learn; since init-soar.
  std::uint32_t instantiation_count() const;
  const Singletons& singletons() const;  ///< learn/singletons.h
  Singletons& mutable_singletons();
  /// How rules were learned, and which explanations are kept from now on (learn/explanation_log.h).
  const ExplanationLog& explanations() const;
  ExplanationLog& mutable_explanations();
  /// States that (force-learn <s>) and (dont-learn <s>) named.
  std::vector<Symbol> StatesForcedToLearn() const;
  std::vector<Symbol> StatesNotToLearn() const;

  // Observing -------------------------------------------------------------------------------------------------------

  /// Adds an observer, or changes the mask of one that is there. Not owned; remove it before it dies.
  void AddObserver(Observer& observer, EventMask events);
  void RemoveObserver(Observer& observer);
  /// The events that anybody listens to.
  EventMask observed() const;

  // Inspecting ------------------------------------------------------------------------------------------------------

  const SymbolTable& symbols() const;
  /// For interning what a command names.
  SymbolTable& mutable_symbols();
  const WorkingMemory& memory() const;
  const GoalStack& goals() const;
  const Rete& rete() const;
  const AgentCounters& counters() const;
  std::string_view ProductionName(InstantiationId id) const;  ///< "justify1" and the like included.
  /// The elements that an instantiation's positive conditions matched, in condition order.
  std::span<const WmeId> MatchedWmes(InstantiationId id) const;
  /// The justifications that live, oldest first, as rules with literal conditions (`print --justifications`).
  std::vector<ProductionPtr> Justifications() const;
  /// The justification that an instantiation is of, as a rule; null if it is of none.
  ProductionPtr JustificationOf(InstantiationId id) const;
  /// False if there is none of this name, or the agent is running.
  bool ExciseJustification(std::string_view name);
  WmeInfo Describe(WmeId id) const;
  GoalInfo Describe(const Goal& goal) const;
  /// The selected operator of a goal, or none.
  Symbol OperatorOf(const Goal& goal) const;
  /// The preferences of one type in a slot, in list order.
  std::vector<PreferenceId> PreferencesOf(SlotId slot, PreferenceType type) const;
  /// The candidates of a goal's operator slot with the chances that exploration gives them, in candidate order; empty
  /// if the decision would be an impasse or need no choice.
  struct CandidateChance {
    PreferenceId preference = PreferenceId::kNone;
    Symbol value;
    double numeric_value = 0;
    double probability = 0;
  };
  std::vector<CandidateChance> SelectionProbabilities(const Goal& goal) const;
  /// What the decision procedure says of the preferences that stand in a goal's operator slot now, with who would be
  /// dropped and why (decide/decision_trace.h). Draws nothing at random. Valid until the agent runs or is asked again.
  DecisionReport ExplainDecision(const Goal& goal) const;

  // Input and output ------------------------------------------------------------------------------------------------

  InputLink& input();
  const InputLink& input() const;
  const OutputLink& output() const;
  Symbol InputLinkIdentifier() const;
  Symbol OutputLinkIdentifier() const;
  /// `wm add`: an input element on any identifier, at once. Refused while running.
  Result<WmeId> AddWme(Symbol id, Symbol attribute, Symbol value, bool acceptable = false);
  /// A new identifier for `wm add` with value `*`.
  Symbol NewIdentifier(char letter);
  /// A new identifier with a name that no identifier has, on the level of `parent`, an identifier in working memory.
  Symbol NewIdentifier(char letter, std::uint64_t number, Symbol parent);
  /// `wm remove`: any element, at once. Preferences stay: the element of a rule comes back when another preference
  /// enters or leaves its slot, and the operator whose proposal goes stays selected.
  Result<void> RemoveWme(WmeId wme);

  /// Functions of the host that rules call with (exec name ...) or (name ...). The argument is what the rule gave,
  /// without blanks between; the answer is a symbol, or none for no value. An error skips the action and is printed. It
  /// runs on the agent's thread in the middle of a phase and must not run, initialise or change the agent.
  /// `is_there`: whether there is a function of this name; rules may then call it without `exec`.
  void SetUserFunctions(std::function<Result<Symbol>(Agent&, std::string_view name, std::span<const Symbol>)> function,
                        std::function<bool(std::string_view name)> is_there = {});
  /// Runs a command line for (cmd ...) and gives its text.
  void SetCommandRunner(std::function<std::string(Agent&, std::string_view line)> runner);

  /// Long-term memory: semantic and episodic memory, activation of working memory (longterm/long_term.h).
  LongTerm& long_term();
  const LongTerm& long_term() const;

  /// The spatial visual system (imagery/imagery.h); made if there is none.
  Imagery& imagery();
  /// The same, or null if nobody has asked for it yet.
  const Imagery* find_imagery() const;

  // Memory ----------------------------------------------------------------------------------------------------------

  std::size_t MemoryBytes() const;        ///< This agent's own part; of the rules those that it learned.
  std::size_t SharedMemoryBytes() const;  ///< Rules and network, which agents with equal rules share.
  /// Checks the invariants of support, links, slots and matches; the first violation in words, or empty.
  std::string CheckInvariants() const;

 private:
  /// Excises the rule of this name, if there is one.
  void ExciseNamed(std::string_view name, LoadOutcome& outcome);
  /// Adds a rule whose name no other has.
  void Enter(ProductionPtr production, LoadOutcome& outcome, bool ignore_number);

  /// False if memory ran out meanwhile.
  template <typename Work>
  bool Guarded(Work work);
  void PrepareMatch();
  template <typename Work>
  RunResult RunGuarded(Work work);
  /// Halts the agent for good and says so. `rule`: the rule whose addition took too much, if it was one.
  void BreakDown(std::string_view rule = {});
  void Replace(ProductionPtr production, LoadOutcome& outcome, bool ignore_number);

  std::unique_ptr<Engine> engine_;
  std::string breakdown_;
};

}  // namespace soarbox::kernel
