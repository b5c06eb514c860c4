// SPDX-License-Identifier: BSD-2-Clause
#include "sim/mind_log.h"

#include <string_view>

#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Observation.h"
#endif

namespace soarbox::sim {
namespace {

struct MindNotes {
  std::vector<std::string> percepts, commands, decisions, details;
};

}  // namespace

#ifdef SOARBOX_OWN_KERNEL

struct MindLog::Listener final : MindObserver {
  static std::string Indent(int level) {
    return std::string(level > 1 ? 3 * static_cast<std::size_t>(level - 1) : 0, ' ');
  }
  /// Says how many decisions stand in front of a detail.
  std::string After() const { return std::to_string(notes.decisions.size()) + " "; }

  /// Notes what a level of the goal stack is about now; those below it are gone.
  void Settle(int level, std::string_view operator_name) {
    if (level < 1 || level > 1000) return;
    operators.resize(static_cast<std::size_t>(level - 1));
    if (!operator_name.empty()) operators.emplace_back(operator_name);
  }

  void OnOperator(int level, std::string_view, std::string_view id, std::string_view name) override {
    Settle(level, name.empty() ? id : name);
    std::string line = Indent(level) + "O: " + std::string(id);
    if (!name.empty()) line.append(" (").append(name).append(")");
    notes.decisions.push_back(std::move(line));
  }
  void OnState(int level, std::string_view state, std::string_view impasse, std::string_view attribute) override {
    Settle(level, {});
    std::string line = Indent(level) + "==>S: " + std::string(state);
    if (level > 1) line.append(" (").append(attribute).append(" ").append(impasse).append(")");
    notes.decisions.push_back(std::move(line));
  }
  void OnStateGone(int level, std::string_view state) override {
    Settle(level, {});
    notes.decisions.push_back(Indent(level) + "<==S: " + std::string(state));
  }
  void OnHalt() override { notes.decisions.emplace_back("halt"); }
  void OnFiring(std::string_view rule, int, bool retracts) override {
    notes.details.push_back(After() + (retracts ? "retract " : "fire ") + std::string(rule));
  }
  void OnElement(bool added, std::uint64_t timetag, std::string_view id, std::string_view attribute,
                 std::string_view value, bool acceptable) override {
    std::string line = After() + (added ? "+ " : "- ") + std::to_string(timetag) + ": ";
    line.append(id).append(" ^").append(attribute).append(" ").append(value);
    if (acceptable) line.append(" +");
    notes.details.push_back(std::move(line));
  }

  MindNotes notes;
  std::vector<std::string> operators;  ///< By level of the goal stack.
  std::unique_ptr<Observation> observation;
};

void MindLog::Listen(sml::Agent& agent, MindDetail detail) {
  listener_->observation.reset();
  if (detail == MindDetail::kNone) return;
  listener_->observation = ObserveMind(
      agent, *listener_, detail == MindDetail::kAll ? soarbox::MindDetail::kAll : soarbox::MindDetail::kDecisions);
}

#else

struct MindLog::Listener {
  MindNotes notes;
  std::vector<std::string> operators;
};

void MindLog::Listen(sml::Agent&, MindDetail) {}

#endif

MindLog::MindLog() : listener_(std::make_unique<Listener>()) {}
MindLog::~MindLog() = default;
MindLog::MindLog(MindLog&&) noexcept = default;
MindLog& MindLog::operator=(MindLog&&) noexcept = default;

void MindLog::Clear() {
  MindNotes& notes = listener_->notes;
  for (auto* lines : {&notes.percepts, &notes.commands, &notes.decisions, &notes.details}) lines->clear();
}

std::vector<std::string>& MindLog::percepts() {
  return listener_->notes.percepts;
}

const std::vector<std::string>& MindLog::percepts() const {
  return listener_->notes.percepts;
}

const std::vector<std::string>& MindLog::commands() const {
  return listener_->notes.commands;
}

std::vector<std::string>& MindLog::commands() {
  return listener_->notes.commands;
}

const std::vector<std::string>& MindLog::decisions() const {
  return listener_->notes.decisions;
}

std::string MindLog::Operators() const {
  std::string all;
  for (const std::string& name : listener_->operators) {
    if (!name.empty()) all += (all.empty() ? "" : " > ") + name;
  }
  return all;
}

const std::vector<std::string>& MindLog::details() const {
  return listener_->notes.details;
}

}  // namespace soarbox::sim
