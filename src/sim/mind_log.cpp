// SPDX-License-Identifier: BSD-2-Clause
#include "sim/mind_log.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Observation.h"
#endif

namespace soarbox::sim {
namespace {

struct MindNotes {
  std::vector<std::string> percepts, commands, command_rules, decisions, reasons, details;
  std::vector<std::pair<std::uint64_t, std::string>> rules_of_output;  ///< By time tag.
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
    waits_in.clear();
    if (level < 1 || level > 1000) return;
    operators.resize(static_cast<std::size_t>(level - 1));
    if (!operator_name.empty()) operators.emplace_back(operator_name);
  }
  void Decided(std::string line) {
    is_told = true;
    notes.decisions.push_back(std::move(line));
    notes.reasons.emplace_back();
  }

  void OnOperator(int level, std::string_view, std::string_view id, std::string_view name) override {
    Settle(level, name.empty() ? id : name);
    std::string line = Indent(level) + "O: " + std::string(id);
    if (!name.empty()) line.append(" (").append(name).append(")");
    Decided(std::move(line));
  }
  void OnState(int level, std::string_view state, std::string_view impasse, std::string_view attribute) override {
    // A program that waits says so in each cycle; once is enough, however long it waits.
    is_told = waits_in != state;
    if (!is_told) return;
    Settle(level, {});
    waits_in = state;
    std::string line = Indent(level) + "==>S: " + std::string(state);
    if (level > 1) line.append(" (").append(attribute).append(" ").append(impasse).append(")");
    Decided(std::move(line));
  }
  void OnStateGone(int level, std::string_view state) override {
    Settle(level, {});
    Decided(Indent(level) + "<==S: " + std::string(state));
  }
  void OnHalt() override { Decided("halt"); }
  void OnReason(std::string_view reason) override {
    if (is_told) notes.reasons.back() = reason;
  }
  void OnCommand(std::uint64_t timetag, std::string_view, std::string_view rule) override {
    if (!rule.empty()) notes.rules_of_output.emplace_back(timetag, rule);
  }
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
  std::string waits_in;                ///< The state that was told last, if nothing was since.
  bool is_told = false;                ///< The last decision was, so that its reason counts.
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
  for (auto* lines :
       {&notes.percepts, &notes.commands, &notes.command_rules, &notes.decisions, &notes.reasons, &notes.details})
    lines->clear();
  notes.rules_of_output.clear();
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

const std::vector<std::string>& MindLog::command_rules() const {
  return listener_->notes.command_rules;
}

void MindLog::Say(std::string command, std::uint64_t tag) {
  MindNotes& notes = listener_->notes;
  notes.commands.push_back(std::move(command));
  const auto at = std::find_if(notes.rules_of_output.begin(), notes.rules_of_output.end(),
                               [&](const auto& entry) { return entry.first == tag; });
  notes.command_rules.push_back(at == notes.rules_of_output.end() ? std::string() : at->second);
}

const std::vector<std::string>& MindLog::reasons() const {
  return listener_->notes.reasons;
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
