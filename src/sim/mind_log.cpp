// SPDX-License-Identifier: BSD-2-Clause
#include "sim/mind_log.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "mind/decision_codec.h"
#include "soarbox_Observation.h"
#endif

namespace soarbox::sim {
namespace {

struct TickOfMind {
  MindNotes notes;
  MindWords words;         ///< Of the notes when they had so many bytes.
  std::size_t worded = 0;  ///< None: no words.
};

}  // namespace

#ifdef SOARBOX_OWN_KERNEL

struct MindLog::Listener final : MindObserver {
  /// Notes what a level of the goal stack is about now; those below it are gone.
  void Settle(int level, std::string_view operator_name) {
    waits_in.clear();
    if (level < 1 || level > 1000) return;
    const auto above = static_cast<std::size_t>(level - 1);
    // Names keep their memory from decision to decision.
    if (operators.size() < above + 1) operators.resize(above + 1);
    for (std::size_t i = depth; i < above; ++i) operators[i].clear();
    operators[above] = operator_name;
    depth = operator_name.empty() ? above : above + 1;
  }

  void OnOperator(int level, std::string_view, std::string_view id, std::string_view name) override {
    Settle(level, name.empty() ? id : name);
    tick.notes.NoteOperator(level, id, name);
    NoteDecided();
  }
  void OnState(int level, std::string_view state, std::string_view impasse, std::string_view attribute) override {
    // A program that waits says so in each cycle; once is enough, however long it waits.
    if (waits_in == state) {
      decided.clear();
      return;
    }
    Settle(level, {});
    waits_in = state;
    tick.notes.NoteState(level, state, impasse, attribute);
    NoteDecided();
  }
  void OnStateGone(int level, std::string_view state) override {
    Settle(level, {});
    tick.notes.NoteStateGone(level, state);
  }
  void OnHalt() override { tick.notes.NoteHalt(); }
  void OnDecided(const mind::DecisionView& decision) override {
    decided.clear();
    mind::Pack(decision, decided);
  }
  void NoteDecided() {
    tick.notes.NoteDecided(decided);
    decided.clear();
  }
  void OnRecall(int level, bool is_episode, std::uint64_t number, std::string_view question, std::string_view answer,
                std::string_view reason) override {
    tick.notes.NoteRecall(level, is_episode, number, question, answer);
    tick.notes.NoteReason(reason);
  }
  void OnLearned(int level, std::string_view rule, std::string_view reason) override {
    tick.notes.NoteLearned(level, rule);
    tick.notes.NoteReason(reason);
  }
  void OnValue(std::string_view rule, double value) override { tick.notes.NoteValue(rule, value); }
  void OnReward(double reward) override { tick.notes.NoteReward(reward); }
  void OnEpisodeEnd() override { tick.notes.NoteEpisodeEnd(); }
  void OnCommand(std::uint64_t timetag, std::string_view, std::string_view rule) override {
    if (!rule.empty()) tick.notes.NoteRuleOfCommand(timetag, rule);
  }
  void OnFiring(std::string_view rule, int, bool retracts) override { tick.notes.NoteFiring(rule, retracts); }
  void OnElement(bool added, std::uint64_t timetag, std::string_view id, std::string_view attribute,
                 std::string_view value, bool acceptable) override {
    tick.notes.NoteElement(added, timetag, id, attribute, value, acceptable);
  }

  TickOfMind tick;
  std::vector<std::string> operators;  ///< By level of the goal stack, the first `depth` of them.
  std::size_t depth = 0;
  std::string waits_in;  ///< The state that was told last, if nothing was since.
  std::string decided;   ///< What was said of the decision that comes next, packed.
  std::unique_ptr<Observation> observation;
};

void MindLog::Listen(sml::Agent& agent, MindDetail detail) {
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
  TickOfMind& tick = listener_->tick;
  tick.notes.Clear();
  if (tick.worded > 0) tick.words = {};
  tick.worded = 0;
}

MindNotes& MindLog::notes() {
  return listener_->tick.notes;
}

const MindNotes& MindLog::notes() const {
  return listener_->tick.notes;
}

const MindWords& MindLog::words() const {
  TickOfMind& tick = listener_->tick;
  if (tick.notes.bytes() != tick.worded) {
    tick.words = tick.notes.Words();
    tick.worded = tick.notes.bytes();
  }
  return tick.words;
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
