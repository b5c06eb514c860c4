// SPDX-License-Identifier: BSD-2-Clause
#include "sim/mind_log.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Observation.h"
#endif

namespace soarbox::sim {
namespace {

/// What is recorded for all kernels.
struct TickOfMind {
  mind::EventLog events;
  /// Makers of elements on the output link: the rule's name ends at this position in `names` and begins at the end of
  /// the previous one.
  struct Maker {
    std::uint64_t timetag = 0;
    std::size_t name_end = 0;
  };
  std::vector<Maker> makers;
  std::string names;
  mind::CommandSaid said;  ///< Temporary.
};

void AddParameters(const vocabulary::PerceptList& list, std::uint32_t depth, std::vector<mind::Parameter>& parameters) {
  for (const vocabulary::Percept& percept : list) {
    if (parameters.size() >= mind::kMostParameters) return;
    mind::Parameter& parameter = parameters.emplace_back();
    parameter.depth = depth;
    parameter.attribute = percept.attribute;
    if (const auto* below = std::get_if<vocabulary::PerceptList>(&percept.value)) {
      parameter.is_object = true;
      AddParameters(*below, depth + 1, parameters);
    } else if (const auto* integer = std::get_if<std::int64_t>(&percept.value)) {
      parameter.value = *integer;
    } else if (const auto* number = std::get_if<double>(&percept.value)) {
      parameter.value = *number;
    } else {
      parameter.value = std::string_view(*percept.Text());
    }
  }
}

}  // namespace

#ifdef SOARBOX_OWN_KERNEL

struct MindLog::Listener final : MindObserver {
  /// Stores the operator of a level of the goal stack; removes the levels below it.
  void Settle(int level, std::string_view operator_name) {
    waits_in.clear();
    if (level < 1 || level > 1000) return;
    const auto above = static_cast<std::size_t>(level - 1);
    if (above + 1 == depth && operators[above] == operator_name) return;  // Unchanged.
    // The memory of names is reused from decision to decision.
    if (operators.size() < above + 1) operators.resize(above + 1);
    for (std::size_t i = depth; i < above; ++i) operators[i].clear();
    if (operators[above] != operator_name) operators[above] = operator_name;
    depth = operator_name.empty() ? above : above + 1;
  }

  void OnOperator(int level, std::string_view id, std::string_view name) override {
    Settle(level, name.empty() ? id : name);
    tick.events.Add(mind::OperatorSelected{level, id, name, std::exchange(decided, {})});
  }
  void OnState(int level, std::string_view state, mind::StateReason reason, bool on_operator) override {
    // A waiting program reports this in each cycle; it is recorded only once.
    const std::string_view said = std::exchange(decided, {});
    if (waits_in == state) return;
    Settle(level, {});
    waits_in = state;
    tick.events.Add(mind::StateMade{level, state, reason, on_operator, said});
  }
  void OnStateGone(int level, std::string_view state) override {
    Settle(level, {});
    tick.events.Add(mind::StateGone{level, state});
  }
  void OnHalt() override { tick.events.Add(mind::Halted{}); }
  void OnDecided(std::string_view decision) override { decided = decision; }
  void OnRecall(int level, bool is_episode, std::uint64_t number, std::string_view question, std::string_view answer,
                std::string_view reason) override {
    tick.events.Add(mind::Recalled{level, is_episode, number, question, answer, reason});
  }
  void OnLearned(const mind::RuleLearned& learned) override { tick.events.Add(learned); }
  void OnValue(std::string_view rule, double value) override { tick.events.Add(mind::ValueUpdated{rule, value}); }
  void OnReward(double reward) override { tick.events.Add(mind::RewardReceived{reward}); }
  void OnEpisodeEnd() override { tick.events.Add(mind::EpisodeEnded{}); }
  void OnCommand(std::uint64_t timetag, std::string_view rule) override {
    if (rule.empty()) return;
    tick.names += rule;
    tick.makers.push_back({timetag, tick.names.size()});
  }
  void OnFiring(std::string_view rule, int, bool retracts) override {
    tick.events.Add(mind::RuleFired{rule, retracts});
  }
  void OnElement(const mind::ElementChanged& element) override { tick.events.Add(element); }

  TickOfMind tick;
  std::vector<std::string> operators;  ///< By level of the goal stack; only the first `depth` are valid.
  std::size_t depth = 0;
  std::string waits_in;      ///< The state that was reported last, if nothing was reported since then.
  std::string_view decided;  ///< The packed record of the next decision; it belongs to the observer's caller.
  std::unique_ptr<Observation> observation;
};

void MindLog::Listen(sml::Agent& agent, MindDetail detail) {
  listener_->decided = {};
  listener_->observation.reset();
  listener_->waits_in.clear();
  if (detail == MindDetail::kNone) return;
  listener_->observation = ObserveMind(
      agent, *listener_, detail == MindDetail::kAll ? soarbox::MindDetail::kAll : soarbox::MindDetail::kDecisions);
}

#else

struct MindLog::Listener {
  TickOfMind tick;
  std::vector<std::string> operators;
  std::size_t depth = 0;
};

void MindLog::Listen(sml::Agent&, MindDetail) {}

#endif

MindLog::MindLog() : listener_(std::make_unique<Listener>()) {}
MindLog::~MindLog() = default;
MindLog::MindLog(MindLog&&) noexcept = default;
MindLog& MindLog::operator=(MindLog&&) noexcept = default;

void MindLog::Clear() {
  listener_->tick.events.Clear();
  listener_->tick.makers.clear();
  listener_->tick.names.clear();
}

mind::EventLog& MindLog::events() {
  return listener_->tick.events;
}

const mind::EventLog& MindLog::events() const {
  return listener_->tick.events;
}

void MindLog::NoteCommand(std::uint64_t timetag, std::string_view name, const vocabulary::PerceptList& parameters) {
  TickOfMind& tick = listener_->tick;
  mind::CommandSaid& said = tick.said;
  said.timetag = timetag;
  said.name = name;
  said.rule = {};
  said.parameters.clear();
  AddParameters(parameters, 0, said.parameters);
  std::size_t begin = 0;
  for (const TickOfMind::Maker& maker : tick.makers) {
    if (maker.timetag == timetag) said.rule = std::string_view(tick.names).substr(begin, maker.name_end - begin);
    begin = maker.name_end;
  }
  tick.events.Add(said);
}

std::string MindLog::Operators() const {
  std::string all;
  for (std::size_t i = 0; i < listener_->depth; ++i) {
    const std::string& name = listener_->operators[i];
    if (!name.empty()) all += (all.empty() ? "" : " > ") + name;
  }
  return all;
}

}  // namespace soarbox::sim
