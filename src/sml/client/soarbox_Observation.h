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

/// Sees what the mind of a client's agent does, in the order in which it happens. What Soarbox's own kernel tells
/// besides the client API: there is no text to format, no document to read, and what nobody asked for costs nothing.
///
/// Called on the thread that runs the agent, in the middle of its cycle: note what is told and return; call nothing of
/// the client API. Texts are valid during the call only. Levels count from 1, the top state.
class MindObserver {
 public:
  virtual ~MindObserver() = default;

  /// An operator was selected. `name` is its ^name, or empty.
  virtual void OnOperator(int level, std::string_view id, std::string_view name) = 0;
  /// An impasse made a state. Also told after init-soar for the top state.
  virtual void OnState(int level, std::string_view state, mind::StateReason reason, bool on_operator) = 0;
  /// A state went, with all below it, because its impasse was resolved or its reasons have gone.
  virtual void OnStateGone(int level, std::string_view state) = 0;
  virtual void OnHalt() = 0;
  /// Before OnOperator and OnState, if preferences spoke: what the decision procedure said of them, packed
  /// (mind/decision.h). Valid until this is told again.
  virtual void OnDecided(std::string_view decision) { (void)decision; }
  /// Long-term memory answered a command of rules. `number`: of the object, or of the episode; 0: nothing came.
  /// `question`: "^kind ammo"; `answer`: of an object some of what is known of it; `reason`: why that came, or nothing.
  virtual void OnRecall(int level, bool is_episode, std::uint64_t number, std::string_view question,
                        std::string_view answer, std::string_view reason) {
    (void)level;
    (void)is_episode;
    (void)number;
    (void)question;
    (void)answer;
    (void)reason;
  }
  /// A rule was learned from what went on in a state of this level.
  virtual void OnLearned(const mind::RuleLearned& learned) { (void)learned; }
  /// Reinforcement learning gives a rule another number.
  virtual void OnValue(std::string_view rule, double value) {
    (void)rule;
    (void)value;
  }
  /// Reward was collected, before the numbers that it moves; other than 0.
  virtual void OnReward(double reward) { (void)reward; }
  /// What was learned by reward so far belongs together: the agent halted, began again, or selected an operator for
  /// which no learning rule speaks while temporal-extension is off.
  virtual void OnEpisodeEnd() {}
  /// Something new stands directly on the output link: the rule that made it.
  virtual void OnCommand(std::uint64_t timetag, std::string_view rule) {
    (void)timetag;
    (void)rule;
  }

  /// A rule fired (or what it made goes, because it matches no longer) for a state of this level; 0 if it touches none.
  /// Told in detail only, as are elements.
  virtual void OnFiring(std::string_view rule, int level, bool retracts) = 0;
  virtual void OnElement(const mind::ElementChanged& element) = 0;
  /// Its rules wrote this: (write ...), or one of their functions failed, or they fire without end. Traces, which go
  /// the same way to clients, are not among it.
  virtual void OnWritten(std::string_view text) { (void)text; }
  /// An action of this rule could not be done; why was written just before.
  virtual void OnActionFailed(std::string_view rule, std::string_view text) {
    (void)rule;
    (void)text;
  }
  /// Rules fired without end in one phase, and max-elaborations ended it; this one would have fired next. Told once.
  virtual void OnEndlessFiring(std::string_view rule) { (void)rule; }
};

enum class MindDetail : std::uint8_t {
  kDecisions,
  kAll,
  kWritten,  ///< OnWritten, OnActionFailed and OnEndlessFiring alone.
};

/// Ends when it is destroyed, which must happen before the agent or the observer goes.
class EXPORT Observation {
 public:
  virtual ~Observation() = default;
};

/// Null if the agent's kernel is in another process: then only the client API tells what there is. While decisions are
/// told, the kernel notes how rules are learned (MindInspection::Lessons).
std::unique_ptr<Observation> EXPORT ObserveMind(sml::Agent& agent, MindObserver& observer, MindDetail detail);

/// Holds the kernel of an agent while it lives, so that the calls of the client API in between need not take it one by
/// one: for those who write much input at once. Not to be held over a run. Does nothing if the kernel is gone.
class EXPORT CallBatch {
 public:
  explicit CallBatch(sml::Agent& agent);
  ~CallBatch();
  CallBatch(const CallBatch&) = delete;
  CallBatch& operator=(const CallBatch&) = delete;

 private:
  server::CallMutex* held_ = nullptr;
};

/// What an agent takes, in bytes, without the rules of its files, which it may share with others; 0 if its kernel is in
/// another process.
std::size_t EXPORT MindMemoryBytes(sml::Agent& agent);

/// The rules that an agent has learned and still has; 0 if its kernel is in another process.
std::size_t EXPORT MindLearnedRules(sml::Agent& agent);
/// The rule that most of them were learned from, and how many were.
struct LearnedSource {
  std::string rule;
  std::size_t count = 0;
};
LearnedSource EXPORT MindLearnedFrom(sml::Agent& agent);

/// How often rules of the agent have fired since it was made or initialised; 0 if its kernel is in another process.
std::uint64_t EXPORT MindFirings(sml::Agent& agent);
/// The rule that has fired most often, and how often.
struct BusyRule {
  std::string rule;
  std::uint64_t firings = 0;
};
BusyRule EXPORT MindBusiestRule(sml::Agent& agent);

/// How many partial matches the agent may have ('soar max-partial-matches'); 0 if its kernel is in another process.
std::uint32_t EXPORT MindMatchLimit(sml::Agent& agent);
void EXPORT SetMindMatchLimit(sml::Agent& agent, std::uint32_t most);

/// To how many bytes (as MindMemoryBytes counts) the agent may grow; while it runs beyond that it breaks down as if
/// memory had run out. Does nothing if its kernel is in another process.
void EXPORT SetMindMemoryLimit(sml::Agent& agent, std::size_t bytes);

}  // namespace soarbox
