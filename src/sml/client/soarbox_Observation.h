// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "Export.h"
#include "mind/event.h"

namespace sml {
class Agent;
}

namespace soarbox {

namespace server {
class CallMutex;
}

/// Receives the events in the mind of a client's agent, in order. Provides the data that only Soarbox's kernel has,
/// without formatting of text or parsing of documents. Events that no observer requested cost nothing.
///
/// The functions are called on the thread that runs the agent, during its decision cycle. They must only store the data
/// and return; they must not call the client API. Texts are valid only during the call. Levels are counted from 1, the
/// top state.
class MindObserver {
 public:
  virtual ~MindObserver() = default;

  /// An operator was selected. `name` is its ^name, or empty.
  virtual void OnOperator(int level, std::string_view id, std::string_view name) = 0;
  /// An impasse created a state. Also called after init-soar for the top state.
  virtual void OnState(int level, std::string_view state, mind::StateReason reason, bool on_operator) = 0;
  /// A state and all states below were removed, because the impasse was resolved or its causes were removed.
  virtual void OnStateGone(int level, std::string_view state) = 0;
  virtual void OnHalt() = 0;
  /// Called before OnOperator and OnState, if there were preferences: the packed decision (mind/decision_facts.h).
  /// Valid until the next call.
  virtual void OnDecided(std::string_view decision) { (void)decision; }
  /// The result of a command of rules to long-term memory. `number`: that of the object or the episode; 0: nothing was
  /// found. `question`: "^kind ammo". `answer`: for an object, some of its augmentations. `reason`: why this was found,
  /// or nothing.
  virtual void OnRecall(int level, bool is_episode, std::uint64_t number, std::string_view question,
                        std::string_view answer, std::string_view reason) {
    (void)level;
    (void)is_episode;
    (void)number;
    (void)question;
    (void)answer;
    (void)reason;
  }
  /// A rule was learned from the reasoning in a state of this level.
  virtual void OnLearned(const mind::RuleLearned& learned) { (void)learned; }
  /// Reinforcement learning changed the number of a rule.
  virtual void OnValue(std::string_view rule, double value) {
    (void)rule;
    (void)value;
  }
  /// A reward other than 0 was collected. Called before the numbers that it changes.
  virtual void OnReward(double reward) { (void)reward; }
  /// The end of an episode of reinforcement learning: the agent halted, was initialized, or selected an operator
  /// without a learning rule while temporal-extension is off.
  virtual void OnEpisodeEnd() {}
  /// A new element is directly on the output link; `rule` created it.
  virtual void OnCommand(std::uint64_t timetag, std::string_view rule) {
    (void)timetag;
    (void)rule;
  }

  /// A rule fired for a state of this level (0: it matches no state). `retracts`: it no longer matches, and its results
  /// are removed. Called only with MindDetail::kAll, like OnElement.
  virtual void OnFiring(std::string_view rule, int level, bool retracts) = 0;
  virtual void OnElement(const mind::ElementChanged& element) = 0;
  /// Text that its rules wrote with (write ...), or messages about failed functions or endless firing. Excludes traces,
  /// which clients receive through the same channel.
  virtual void OnWritten(std::string_view text) { (void)text; }
  /// An action of this rule failed; the reason was reported to OnWritten just before.
  virtual void OnActionFailed(std::string_view rule, std::string_view text) {
    (void)rule;
    (void)text;
  }
  /// Rules fired without end in one phase, which max-elaborations ended. `rule` would have fired next. Called once.
  virtual void OnEndlessFiring(std::string_view rule) { (void)rule; }
};

enum class MindDetail : std::uint8_t {
  kDecisions,
  kAll,
  kWritten,  ///< Only OnWritten, OnActionFailed and OnEndlessFiring.
};

/// An observation ends with the destruction of this object, which must precede that of the agent and the observer.
class EXPORT Observation {
 public:
  virtual ~Observation() = default;
};

/// Returns null if the agent's kernel is in another process: only the client API is available then. While decisions are
/// observed, the kernel records how rules are learned (MindInspection::LearnedRules).
std::unique_ptr<Observation> EXPORT ObserveMind(sml::Agent& agent, MindObserver& observer, MindDetail detail);

/// Locks the kernel of an agent during its lifetime, so that calls of the client API in between need not lock it one by
/// one: for clients that write much input at once. Must not be held during a run. Has no effect if the kernel no longer
/// exists.
class EXPORT CallBatch {
 public:
  explicit CallBatch(sml::Agent& agent);
  ~CallBatch();
  CallBatch(const CallBatch&) = delete;
  CallBatch& operator=(const CallBatch&) = delete;

 private:
  server::CallMutex* held_ = nullptr;
};

/// Memory of an agent in bytes, without the rules of its files, which other agents may share; 0 if its kernel is in
/// another process.
std::size_t EXPORT MindMemoryBytes(sml::Agent& agent);

/// Number of learned rules that the agent still has; 0 if its kernel is in another process.
std::size_t EXPORT MindLearnedRules(sml::Agent& agent);
/// The rule that most of them were learned from, and their number.
struct LearnedSource {
  std::string rule;
  std::size_t count = 0;
};
LearnedSource EXPORT MindLearnedFrom(sml::Agent& agent);

/// Number of rule firings since the agent was created or initialized; 0 if its kernel is in another process.
std::uint64_t EXPORT MindFirings(sml::Agent& agent);
/// The rule that has fired most often, and its number of firings.
struct BusyRule {
  std::string rule;
  std::uint64_t firings = 0;
};
BusyRule EXPORT MindBusiestRule(sml::Agent& agent);

/// Maximum number of partial matches ('soar max-partial-matches'); 0 if its kernel is in another process.
std::uint32_t EXPORT MindMatchLimit(sml::Agent& agent);
void EXPORT SetMindMatchLimit(sml::Agent& agent, std::uint32_t most);

/// Sets the maximum memory of an agent, in bytes as counted by MindMemoryBytes. If it grows beyond that while it runs,
/// it breaks down as if memory had run out. Has no effect if its kernel is in another process.
void EXPORT SetMindMemoryLimit(sml::Agent& agent, std::size_t bytes);

}  // namespace soarbox
