// SPDX-License-Identifier: BSD-2-Clause
#include <string>
#include <string_view>
#include <utility>

#include "cli/object_printer.h"
#include "cli/printed_rule.h"
#include "kernel/agent.h"
#include "kernel/learn/explanation_log.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/learn/reinforcement.h"
#include "kernel/observer.h"
#include "sml/client/agent_data.h"
#include "sml/client/hold.h"
#include "sml/client/local_agent_link.h"
#include "sml/server/decision_packer.h"
#include "sml/server/printed_names.h"
#include "soarbox_Observation.h"

namespace soarbox {
namespace {

using cli::SymbolText;
using kernel::Event;

/// The rule that created an element of the output link, or an empty text. Valid while the element exists.
std::string_view RuleOfOutput(const kernel::Agent& agent, kernel::Symbol attribute, std::uint64_t timetag) {
  const kernel::WorkingMemory& memory = agent.memory();
  const kernel::SlotId slot = memory.FindSlot(agent.output().identifier(), attribute);
  if (slot == kernel::SlotId::kNone) return {};
  for (kernel::WmeId wme = memory.slot(slot).wmes; wme != kernel::WmeId::kNone; wme = memory.record(wme).next) {
    if (memory.wme(wme).timetag != timetag) continue;
    const kernel::PreferenceId preference = memory.record(wme).preference;
    if (preference == kernel::PreferenceId::kNone) return {};
    return agent.ProductionName(memory.preference(preference).instantiation);
  }
  return {};
}

mind::StateReason ReasonOf(kernel::ImpasseType impasse) {
  using kernel::ImpasseType;
  static_assert(static_cast<int>(ImpasseType::kNone) == static_cast<int>(mind::StateReason::kTop) &&
                static_cast<int>(ImpasseType::kTie) == static_cast<int>(mind::StateReason::kTie) &&
                static_cast<int>(ImpasseType::kConflict) == static_cast<int>(mind::StateReason::kConflict) &&
                static_cast<int>(ImpasseType::kConstraintFailure) ==
                    static_cast<int>(mind::StateReason::kConstraintFailure) &&
                static_cast<int>(ImpasseType::kNoChange) == static_cast<int>(mind::StateReason::kNoChange));
  return static_cast<mind::StateReason>(impasse);
}

/// Records the events of one agent of a kernel in this process.
class MindObservation final : public Observation, kernel::Observer {
 public:
  MindObservation(kernel::Agent& agent, mind::MindRecord& record, mind::MindDetail detail)
      : agent_(agent), record_(record) {
    kernel::EventMask events = Event::kDecision | Event::kReason | Event::kRun | Event::kOutput | Event::kRecall |
                               Event::kLearning | Event::kReinforcement;
    if (detail == mind::MindDetail::kAll) events = events | Event::kFiring | Event::kWme;
    record_.ForgetWaiting();
    agent_.mutable_explanations().noting = true;
    total_reward_ = agent_.reward().total_reward;
    agent_.AddObserver(*this, events);
  }
  ~MindObservation() override {
    agent_.RemoveObserver(*this);
    agent_.mutable_explanations().noting = false;
  }

 private:
  void OnDecided(const kernel::Agent& agent, const kernel::DecisionReport& report) override {
    decided_for_ = report.goal;
    decision_ = decisions_.Pack(agent, report);
  }
  void OnDecision(const kernel::Agent& agent, const kernel::GoalInfo& goal, std::uint64_t) override {
    if (agent.reinforcement().learning) NoteEpisode(agent, goal);
    // If this state has just been decided, its texts exist already.
    const bool is_known = std::exchange(decided_for_, {}) == goal.goal;
    const std::string_view decision = std::exchange(decision_, {});
    const int level = static_cast<int>(goal.level);
    if (goal.op) {
      if (is_known) {
        const server::DecisionPacker::Operator known = decisions_.Find(goal.op);
        if (!known.id.empty()) return record_.OnOperator({level, known.id, known.name, decision});
      }
      const server::IdentifierText op(agent, goal.op);
      record_.OnOperator({level, op.view(), names_.NameOfOperator(agent, goal.op), decision});
    } else {
      const server::IdentifierText state(agent, goal.goal);
      record_.OnState({level, state.view(), ReasonOf(goal.impasse), goal.on_operator, decision});
    }
  }
  void OnStateRemoved(const kernel::Agent& agent, const kernel::GoalInfo& goal, kernel::GoalRemoval why) override {
    if (why == kernel::GoalRemoval::kWithSuperstate) return;
    record_.OnStateGone({static_cast<int>(goal.level), SymbolText(agent, goal.goal)});
  }
  void OnRecall(const kernel::Agent&, const kernel::RecallInfo& info) override {
    record_.events.Add(mind::Recalled{static_cast<int>(info.level), info.is_episode, info.number, info.question,
                                      info.answer, info.reason});
  }
  void OnHalt(const kernel::Agent& agent) override {
    record_.events.Add(mind::Halted{});
    NoteReward(agent);
    if (std::exchange(is_in_episode_, false)) record_.events.Add(mind::EpisodeEnded{});
  }
  void OnLearned(const kernel::Agent& agent, const kernel::FiringInfo& info) override {
    if (info.production == kernel::ProductionId::kNone ||
        agent.production(info.production).type != kernel::ProductionType::kChunk)
      return;
    const std::deque<kernel::ExplainedRule>& noted = agent.explanations().noted();
    if (noted.empty() || noted.back().name != info.name) return;
    const kernel::ExplainedRule& learned = noted.back();
    const kernel::ExplainedRule::Firing* const base = learned.FindFiring(learned.base);
    record_.events.Add(mind::RuleLearned{learned.level, info.name,
                                         base == nullptr ? std::string_view() : std::string_view(base->rule),
                                         learned.state, ReasonOf(learned.impasse), learned.on_operator});
  }
  void OnRlUpdate(const kernel::Agent& agent, const kernel::RlUpdate& update) override {
    NoteReward(agent);
    record_.events.Add(mind::ValueUpdated{cli::RuleName(agent, agent.production(update.rule)),
                                          update.new_current + update.new_future});
  }
  void OnOutput(const kernel::Agent& agent) override {
    const kernel::Symbol link = agent.output().identifier();
    for (const kernel::OutputChange& change : agent.output().changes()) {
      if (!change.added || change.id != link) continue;
      record_.OnCommand(change.timetag, RuleOfOutput(agent, change.attribute, change.timetag));
    }
  }
  void OnFiring(const kernel::Agent&, const kernel::FiringInfo& info) override {
    record_.events.Add(mind::RuleFired{info.name, false});
  }
  void OnRetracting(const kernel::Agent&, const kernel::FiringInfo& info) override {
    record_.events.Add(mind::RuleFired{info.name, true});
  }
  void OnWmeAdded(const kernel::Agent& agent, const kernel::WmeInfo& wme) override { Tell(agent, wme, true); }
  void OnWmeRemoved(const kernel::Agent& agent, const kernel::WmeInfo& wme) override { Tell(agent, wme, false); }

  void Tell(const kernel::Agent& agent, const kernel::WmeInfo& wme, bool added) {
    const std::string id = SymbolText(agent, wme.id), attribute = SymbolText(agent, wme.attribute),
                      value = SymbolText(agent, wme.value);
    record_.events.Add(
        mind::ElementChanged{added, wme.timetag, id, attribute, value, wme.acceptable, wme.value.IsIdentifier()});
  }

  void NoteReward(const kernel::Agent& agent) {
    const double total = agent.reward().total_reward;
    if (total != total_reward_) record_.events.Add(mind::RewardReceived{total - total_reward_});
    total_reward_ = total;
  }

  /// Detects episodes of the top state.
  void NoteEpisode(const kernel::Agent& agent, const kernel::GoalInfo& goal) {
    if (goal.level != 1) return;
    if (!goal.op) {
      // After init-soar the earlier reward no longer counts.
      total_reward_ = agent.reward().total_reward;
      if (std::exchange(is_in_episode_, false)) record_.events.Add(mind::EpisodeEnded{});
      return;
    }
    NoteReward(agent);
    if (IsLearnedAbout(agent, goal.op)) {
      is_in_episode_ = true;
    } else if (is_in_episode_ && !agent.reinforcement().temporal_extension) {
      is_in_episode_ = false;
      record_.events.Add(mind::EpisodeEnded{});
    }
  }

  /// Whether a learning rule supports this operator of the top state.
  static bool IsLearnedAbout(const kernel::Agent& agent, kernel::Symbol op) {
    const kernel::SlotId slot = agent.goals().at(1).operator_slot;
    if (slot == kernel::SlotId::kNone) return false;
    for (const kernel::PreferenceId id : agent.PreferencesOf(slot, kernel::PreferenceType::kNumericIndifferent)) {
      const kernel::Preference& preference = agent.memory().preference(id);
      if (preference.value != op) continue;
      const kernel::ProductionId rule = agent.FindProduction(agent.ProductionName(preference.instantiation));
      if (rule != kernel::ProductionId::kNone && agent.production(rule).is_rl) return true;
    }
    return false;
  }

  kernel::Agent& agent_;
  mind::MindRecord& record_;
  bool is_in_episode_ = false;
  double total_reward_ = 0;
  server::PrintedNames names_;
  server::DecisionPacker decisions_;
  std::string_view decision_;   ///< The packed record of the next operator or state.
  kernel::Symbol decided_for_;  ///< The state of the decisions in decisions_, until its operator is reported.
};

/// Records what the rules of one agent write.
class OutputObservation final : public Observation, kernel::Observer {
 public:
  OutputObservation(kernel::Agent& agent, mind::RuleOutput& output) : agent_(agent), output_(output) {
    agent_.AddObserver(*this, Event::kPrint | Event::kRun);
  }
  ~OutputObservation() override { agent_.RemoveObserver(*this); }

 private:
  void OnPrint(const kernel::Agent&, std::string_view text) override { output_.Write(text); }
  void OnError(const kernel::Agent& agent, std::string_view text) override {
    output_.Write(text);
    if (const std::string_view rule = agent.FiringRule(); !rule.empty()) output_.NoteFailure(rule, text);
  }
  void OnSceneProblem(const kernel::Agent& agent, kernel::WmeId command, std::string_view problem,
                      std::string_view hint) override {
    const kernel::PreferenceId maker = agent.memory().record(command).preference;
    if (maker == kernel::PreferenceId::kNone) return;
    const std::string_view rule = agent.ProductionName(agent.memory().preference(maker).instantiation);
    if (rule.empty()) return;
    const std::string name(names_.Of(agent, agent.memory().wme(command).attribute));
    output_.NoteFailure(rule, "svs: command " + name + ": " + std::string(problem) + "\n" + std::string(hint));
  }
  void OnWarning(const kernel::Agent& agent, kernel::WarningKind kind, std::string_view text) override {
    // Of the warnings, only endless firing is reported, and only once, because it would recur in each decision.
    if (kind == kernel::WarningKind::kMaxElaborationsPropose || kind == kernel::WarningKind::kMaxElaborationsApply) {
      if (std::exchange(told_of_elaborations_, true)) return;
      output_.Write("Warning: reached max-elaborations: its rules fire again and again in one phase\n");
      if (const std::string_view rule = agent.NextRule(); !rule.empty()) output_.NoteFailure(rule, {});
    }
    if (kind == kernel::WarningKind::kMaxDecisionTime || kind == kernel::WarningKind::kOther) output_.Write(text);
  }
  void OnRuleInterrupt(const kernel::Agent& agent, kernel::ProductionId rule, std::uint32_t) override {
    output_.Write("interrupted by the rule " + std::string(agent.production(rule).name) + "\n");
  }

  kernel::Agent& agent_;
  mind::RuleOutput& output_;
  bool told_of_elaborations_ = false;
  server::PrintedNames names_;
};

/// Returns null if the kernel is in another process.
kernel::Agent* KernelAgent(sml::Agent& agent) {
  auto* link = sml::LocalLinkOf(agent);
  return link == nullptr ? nullptr : &link->hosted().agent();
}

}  // namespace

std::unique_ptr<Observation> ObserveMind(sml::Agent& agent, mind::MindRecord& record, mind::MindDetail detail) {
  kernel::Agent* mind = KernelAgent(agent);
  if (mind == nullptr) return nullptr;
  return std::make_unique<MindObservation>(*mind, record, detail);
}

std::unique_ptr<Observation> ObserveOutput(sml::Agent& agent, mind::RuleOutput& output) {
  kernel::Agent* mind = KernelAgent(agent);
  if (mind == nullptr) return nullptr;
  return std::make_unique<OutputObservation>(*mind, output);
}

CallBatch::CallBatch(sml::Agent& agent) : held_(sml::Hold(sml::AgentData::Of(agent))) {}

std::size_t MindMemoryBytes(sml::Agent& agent) {
  const kernel::Agent* mind = KernelAgent(agent);
  return mind == nullptr ? 0 : mind->MemoryBytes();
}

std::size_t MindLearnedRules(sml::Agent& agent) {
  const kernel::Agent* mind = KernelAgent(agent);
  return mind == nullptr ? 0 : mind->learned_rule_count();
}

LearnedSource MindLearnedFrom(sml::Agent& agent) {
  const kernel::Agent* mind = KernelAgent(agent);
  if (mind == nullptr) return {};
  kernel::LearnedRules learned = mind->LearnedBySource();
  return {std::move(learned.source), learned.of_source};
}

std::uint64_t MindFirings(sml::Agent& agent) {
  const kernel::Agent* mind = KernelAgent(agent);
  return mind == nullptr ? 0 : mind->counters().firings;
}

BusyRule MindBusiestRule(sml::Agent& agent) {
  BusyRule busiest;
  const kernel::Agent* mind = KernelAgent(agent);
  if (mind == nullptr) return busiest;
  for (const kernel::ProductionId id : mind->Productions()) {
    if (mind->FiringCount(id) <= busiest.firings) continue;
    busiest = {std::string(mind->production(id).name), mind->FiringCount(id)};
  }
  return busiest;
}

std::uint32_t MindMatchLimit(sml::Agent& agent) {
  const kernel::Agent* mind = KernelAgent(agent);
  return mind == nullptr ? 0 : mind->settings().max_partial_matches;
}

void SetMindMatchLimit(sml::Agent& agent, std::uint32_t most) {
  if (kernel::Agent* mind = KernelAgent(agent)) mind->mutable_settings().max_partial_matches = most;
}

void SetMindMemoryLimit(sml::Agent& agent, std::size_t bytes) {
  if (kernel::Agent* mind = KernelAgent(agent)) mind->mutable_settings().most_memory_bytes = bytes;
}

void SetMindFiringLimit(sml::Agent& agent, std::uint64_t most) {
  if (kernel::Agent* mind = KernelAgent(agent)) mind->mutable_settings().most_firings = most;
}

}  // namespace soarbox
