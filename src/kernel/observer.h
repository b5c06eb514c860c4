// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

class Agent;
struct DecisionReport;

enum class Phase : std::uint8_t { kInput, kPropose, kDecide, kApply, kOutput };

/// Which rules fire in an elaboration: those with i-support (IE) or those with o-support (PE).
enum class FiringType : std::uint8_t { kIe, kPe };

enum class ImpasseType : std::uint8_t { kNone, kTie, kConflict, kConstraintFailure, kNoChange };

/// The events that an observer subscribes to, as a bit mask. The kernel prepares nothing for an event without
/// subscribers.
enum class Event : std::uint32_t {
  kPhase = 1u << 0,           ///< Begin and end of each phase and decision cycle.
  kElaboration = 1u << 1,     ///< Elaborations, inner elaborations, working memory phases.
  kFiring = 1u << 2,          ///< Rules that fire, are inhibited or retract.
  kWme = 1u << 3,             ///< Elements added to and removed from working memory.
  kPreference = 1u << 4,      ///< Preferences that enter or leave their slots.
  kDecision = 1u << 5,        ///< Operators selected, impasses, states removed; reported once while the agent is idle.
  kPrint = 1u << 6,           ///< Text that rules write and warnings of the architecture.
  kProduction = 1u << 7,      ///< Rules added and excised.
  kRun = 1u << 8,             ///< Halt, interrupts, init-soar.
  kOutput = 1u << 9,          ///< The output link changed.
  kGds = 1u << 10,            ///< Changes of goal dependency sets.
  kAssertion = 1u << 11,      ///< Instantiations created and asserted; matches added to the match set.
  kLearning = 1u << 12,       ///< Justifications and chunks.
  kExploration = 1u << 13,    ///< Candidates and their values when exploration chooses.
  kReinforcement = 1u << 14,  ///< Updates of values by reinforcement learning; gaps in its episodes.
  kRecall = 1u << 15,         ///< Results of long-term memory for commands of rules.
  kReason = 1u << 16,         ///< Why operators are selected and impasses arise.
  kNotLearned = 1u << 17,     ///< Why results get no rule.
  kActivation = 1u << 18,     ///< Elements whose activation is followed.
  kDecisionTrace = 1u << 19,  ///< Operators removed. With kDecision: each decision, even if the agent is idle.
  kBacktrace = 1u << 20,      ///< Each step of learning while it traces what results depend on.
};

using EventMask = std::uint32_t;
constexpr EventMask Mask(Event event) {
  return static_cast<EventMask>(event);
}
constexpr EventMask operator|(Event a, Event b) {
  return Mask(a) | Mask(b);
}
constexpr EventMask operator|(EventMask a, Event b) {
  return a | Mask(b);
}

/// A rule that fires or retracts. Spans and references are valid only during the callback.
struct FiringInfo {
  InstantiationId instantiation = InstantiationId::kNone;
  ProductionId production = ProductionId::kNone;  ///< kNone for justifications that are not in the network.
  const Production* rule = nullptr;               ///< Null for architectural instantiations.
  std::string_view name;                          ///< The rule's name.
  Symbol goal;                                    ///< The lowest goal that it matched; none if it matched no goal.
  GoalLevel level = 0;
  std::span<const WmeId> wmes;  ///< One per positive condition, in match order.
  Symbol touched;               ///< OnInhibited: an identifier that an action would change and whose level is not below
                                ///< `change_level`.
  GoalLevel change_level = 0;   ///< OnInhibited: the level that is changing.
};

/// An element with copies of its contents, so that a listener need not look it up.
struct WmeInfo {
  WmeId wme = WmeId::kNone;
  std::uint64_t timetag = 0;
  Symbol id, attribute, value;
  bool acceptable = false;
};

struct GoalInfo {
  Symbol goal;
  GoalLevel level = 0;
  ImpasseType impasse = ImpasseType::kNone;  ///< The impasse that created the state; kNone for the top state.
  bool on_operator = false;                  ///< ^attribute is operator, not state. True for ties and conflicts.
  Symbol op;                                 ///< The operator selected in this state, or none.
};

enum class GoalRemoval : std::uint8_t {
  kDecision,          ///< "because of a decision."
  kWrongImpasseType,  ///< "because it's the wrong type of impasse."
  kOperatorRemoval,   ///< "because of an operator removal."
  kGdsChange,         ///< "because element in GDS changed. WME: (...)": see OnGdsViolation just before.
  kWithSuperstate,    ///< A state above it is removed; reported after that one.
  kInconsistent,      ///< The consistency check failed: see OnInconsistentDecision, which is called just before.
  kInit,              ///< init-soar or destruction of the agent. Not reported to observers of kDecision.
};

enum class OperatorRemoval : std::uint8_t {
  kProposalGone,  ///< "Operator from context slot (proposal no longer matches)": `wme` is the acceptable element.
  kInconsistent,
  kReplaced,
};

enum class WarningKind : std::uint8_t {
  kMaxElaborationsPropose,
  kMaxElaborationsApply,
  kGoalStackLimit,
  kMaxDecisionTime,
  kAddedAndRemoved,  ///< The newest new element was removed before the match received it; the text names it.
  kLearnedRule,      ///< A rule that is being learned has a problem.
  kOther,
};

/// Why a firing in a substate results in no learned rule.
enum class NotLearned : std::uint8_t {
  kExcluded,       ///< `chunk except`, and the state was named by (dont-learn).
  kNotForced,      ///< `chunk only`, and the state was not named by (force-learn).
  kNotLowest,      ///< `chunk bottom-only`, and a lower state had results.
  kTooMany,        ///< `chunk max-chunks`
  kTooManyAlike,   ///< `chunk max-dupes`
  kUnconditional,  ///< The results depend on no element above the substate.
};

/// An update of a rule's learned number: its two parts (learn/rl_values.h) before and after. Their sum is the number.
struct RlUpdate {
  ProductionId rule = ProductionId::kNone;
  double old_current = 0, old_future = 0;
  double new_current = 0, new_future = 0;
};

/// One step of learning while it traces what results depend on. `kind` determines which fields are set. Valid during
/// the callback only.
struct BacktraceStep {
  enum class Kind : std::uint8_t {
    kResult,       ///< A result is to be traced: `preference`.
    kSelection,    ///< A preference that decided the selection of an operator is to be traced: `preference`.
    kFiring,       ///< A firing with the elements that it tested: `firing`, `grounds`, `locals`, `negated`.
    kKnownFiring,  ///< A firing that was traced before: `firing`.
    kLocals,       ///< The elements of the substate that firings tested are traced from here on.
    kLocal,        ///< One of them is to be traced: `local`.
    kNoMaker,      ///< No rule created it: there is nothing to trace.
    kItem,         ///< It is an item of the impasse and depends on a proposal in the superstate: `grounds`.
    kEnd,          ///< Everything has been traced.
  };
  Kind kind = Kind::kEnd;
  PreferenceId preference = PreferenceId::kNone;
  WmeId local = WmeId::kNone;
  std::string_view firing = {};         ///< The name of the rule.
  std::span<const WmeId> grounds = {};  ///< Elements of higher states, in the order of the conditions.
  std::span<const WmeId> locals = {};   ///< Elements of the substate, in the same order.
  const Production* negated = nullptr;  ///< A rule whose conditions are the negated ones of the firing; null: none.
};

/// The result of a command that rules put on the link of semantic or episodic memory. The texts are valid during the
/// callback only.
struct RecallInfo {
  GoalLevel level = 0;
  bool is_episode = false;
  std::uint64_t number = 0;   ///< Of the retrieved object or episode; 0 if nothing was retrieved.
  std::string_view question;  ///< "^kind ammo ^room <any>", "episode 7", "the next episode".
  std::string_view answer;    ///< For an object, some of its augmentations: "^kind ammo ^name crate".
  std::string_view reason;    ///< Why this object or episode was retrieved, or why nothing was.
};

/// Receives the steps by which learning traces results, if it subscribes to kBacktrace.
class BacktraceObserver {
 public:
  virtual ~BacktraceObserver() = default;
  virtual void OnBacktrace(const Agent&, const BacktraceStep& step) { (void)step; }
};

/// Receives the events of an agent in the order in which they occur. Callbacks run on the agent's thread, between steps
/// of the cycle. They may read everything and change nothing, except that they may request a stop. Each callback
/// belongs to the event named in its comment and is called only if that bit is in the observer's mask.
class Observer : public BacktraceObserver {
 public:
  // kPhase
  virtual void OnPhaseBegin(const Agent&, Phase) {}
  virtual void OnPhaseEnd(const Agent&, Phase) {}
  virtual void OnDecisionCycleBegin(const Agent&) {}
  virtual void OnDecisionCycleEnd(const Agent&) {}

  // kRecall
  virtual void OnRecall(const Agent&, const RecallInfo&) {}

  // kElaboration
  /// Begin and end of one elaboration cycle (a preference phase and a working memory phase).
  virtual void OnElaborationBegin(const Agent&) {}
  virtual void OnElaborationEnd(const Agent&) {}
  /// The preference phase of an elaboration: "--- Firing Productions (PE) For State At Depth 1 ---" in the apply phase.
  virtual void OnPreferencePhase(const Agent&, FiringType, GoalLevel active_level) { (void)active_level; }
  /// A pass of the waterfall: "--- Inner Elaboration Phase, active level 1 goal S1 ---".
  virtual void OnInnerElaboration(const Agent&, GoalLevel, Symbol goal) { (void)goal; }
  /// Before buffered changes are applied: "--- Change Working Memory (PE) ---" in the apply phase.
  virtual void OnWorkingMemoryPhase(const Agent&, FiringType) {}

  // kFiring
  /// Called before the actions run. Text that they write is reported after this call.
  virtual void OnFiring(const Agent&, const FiringInfo&) {}
  /// Called after the actions have run. `preferences`: those that the actions created, newest first.
  virtual void OnFired(const Agent&, const FiringInfo&, std::span<const PreferenceId> preferences) {
    (void)preferences;
  }
  /// A match must wait because a higher level changes in this elaboration: see info.touched and info.change_level.
  virtual void OnInhibited(const Agent&, const FiringInfo&) {}
  /// Called before the first i-supported preference of an instantiation that no longer matches is removed. Not called
  /// for instantiations without such preferences.
  virtual void OnRetracting(const Agent&, const FiringInfo&) {}
  /// Called for every instantiation that no longer matches, even if it has no preferences left.
  virtual void OnRetracted(const Agent&, const FiringInfo&) {}

  // kWme
  virtual void OnWmeAdded(const Agent&, const WmeInfo&) {}
  virtual void OnWmeRemoved(const Agent&, const WmeInfo&) {}

  // kPreference: look the preference up in agent.memory().preference(id).
  virtual void OnPreferenceAdded(const Agent&, PreferenceId) {}
  /// A preference that is not added, because the top state already has an o-supported preference for the same value.
  virtual void OnPreferenceIgnored(const Agent&, PreferenceId) {}
  virtual void OnPreferenceRemoved(const Agent&, PreferenceId) {}

  // kDecision
  /// The decision's line in the trace: an operator was selected in `info.goal` (info.op), or a state was created
  /// (info.op is none). Also called once after init-soar for the top state, and in each idle cycle while wait-snc is
  /// on.
  virtual void OnDecision(const Agent&, const GoalInfo&, std::uint64_t decision) { (void)decision; }
  virtual void OnStateRemoved(const Agent&, const GoalInfo&, GoalRemoval) {}
  virtual void OnOperatorRemoved(const Agent&, const GoalInfo&, OperatorRemoval, const WmeInfo&) {}
  /// "Removing substates of S1 because the operator last selected in S1 is not consistent with ..."
  virtual void OnInconsistentDecision(const Agent&, const GoalInfo&) {}

  // kReason
  /// The outcome of the decision procedure (decide/decision_trace.h). Called before the operator is installed or the
  /// state is created, thus before OnDecision. Not called for an impasse that continues, or if there is no preference
  /// at all.
  virtual void OnDecided(const Agent&, const DecisionReport&) {}

  // kGds
  virtual void OnGdsAdded(const Agent&, const GoalInfo&, const WmeInfo&) {}
  /// The element was removed from working memory (or changed), so the goal will be removed.
  virtual void OnGdsViolation(const Agent&, const GoalInfo&, const WmeInfo&) {}

  // kPrint
  /// Text exactly as rules write it.
  virtual void OnPrint(const Agent&, std::string_view text) { (void)text; }
  /// A message of the architecture about a rule's action, in its final form.
  virtual void OnError(const Agent&, std::string_view text) { (void)text; }
  /// (log n ...) and (trace n ...): printed if that channel or level is on.
  virtual void OnLog(const Agent&, int channel, std::string_view text) {
    (void)channel;
    (void)text;
  }
  virtual void OnTraceText(const Agent&, int level, std::string_view text) {
    (void)level;
    (void)text;
  }
  /// A command to a state's scene is invalid or refers to something that does not exist. `command` is the element with
  /// the command, `problem` describes the error, `hint` a correction. Soar's trace has no such message.
  virtual void OnSceneProblem(const Agent&, WmeId command, std::string_view problem, std::string_view hint) {
    (void)command;
    (void)problem;
    (void)hint;
  }
  /// A warning of the architecture in our words. `kind` lets the trace use Soar's format instead.
  virtual void OnWarning(const Agent&, WarningKind kind, std::string_view text) {
    (void)kind;
    (void)text;
  }

  // kProduction
  virtual void OnProductionAdded(const Agent&, ProductionId) {}
  /// Called before the rule is removed.
  virtual void OnProductionExcised(const Agent&, ProductionId) {}

  // kRun
  /// A rule with `:interrupt` or a break has a new match, its `count`-th. The current run ends after the phase.
  virtual void OnRuleInterrupt(const Agent&, ProductionId, std::uint32_t count) { (void)count; }
  /// The run ended because of a request (command, rule, goal-stack limit). `reason` explains which.
  virtual void OnInterrupt(const Agent&, std::string_view reason) { (void)reason; }
  virtual void OnHalt(const Agent&) {}
  virtual void OnBeforeInit(const Agent&) {}
  virtual void OnAfterInit(const Agent&) {}

  // kOutput
  /// Called in the output phase if anything below the output link changed: read agent.output().changes().
  virtual void OnOutput(const Agent&) {}

  // kAssertion
  virtual void OnInstantiationMade(const Agent&, const FiringInfo&) {}
  virtual void OnInstantiationAsserted(const Agent&, const FiringInfo&) {}

  // kLearning
  /// A chunk or justification of this name is about to be built.
  virtual void OnLearning(const Agent&, std::string_view name) { (void)name; }
  /// The chunk or justification has been built.
  virtual void OnLearned(const Agent&, const FiringInfo&) {}
  /// The chunk or justification duplicates the live rule `original`, so it was not built.
  virtual void OnDuplicateLearned(const Agent&, std::string_view name, std::string_view original) {
    (void)name, (void)original;
  }

  // kNotLearned
  virtual void OnNotLearned(const Agent&, NotLearned why, const FiringInfo&) { (void)why; }
  /// Reasoning in a substate depends on the absence of a local element, and `chunk allow-local-negations` is off.
  /// `negation` is a rule whose only condition is that negated condition.
  virtual void OnLocalNegation(const Agent&, const Production& negation) { (void)negation; }

  // kActivation
  /// The activation of an element is tracked from now on.
  virtual void OnFollowed(const Agent&, WmeId) {}
  /// A tracked element was removed.
  virtual void OnFollowedGone(const Agent&, std::uint64_t timetag) { (void)timetag; }
  /// Number of uses of a tracked element in the decision cycle that ends.
  virtual void OnUses(const Agent&, std::uint64_t timetag, std::uint64_t uses) { (void)timetag, (void)uses; }

  // kExploration
  /// One candidate with its value, each time exploration chooses.
  virtual void OnCandidate(const Agent&, Symbol candidate, double value, double probability) {
    (void)candidate;
    (void)value;
    (void)probability;
  }

  // kReinforcement
  /// Called before the new number takes effect.
  virtual void OnRlUpdate(const Agent&, const RlUpdate&) {}
  /// `begins`: from now on, decisions in this state are made without a rule with a learned number. Else this gap ends.
  virtual void OnRewardGap(const Agent&, Symbol state, bool begins) {
    (void)state;
    (void)begins;
  }
};

}  // namespace soarbox::kernel
