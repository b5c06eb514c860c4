// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/rule_context.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <thread>

#include "kernel/decide/agent_core.h"

namespace soarbox::kernel {

SymbolTable& RuleContext::symbols() {
  return core_.symbols;
}
RandomStream& RuleContext::random() {
  return core_.random;
}

void RuleContext::PrintError(std::string_view text) {
  core_.observers.Notify(Event::kPrint, [&](Observer& o) { o.OnError(core_.agent, text); });
}

void RuleContext::Write(std::string_view text) {
  if (core_.agent_writes) core_.observers.Print(text);
}

void RuleContext::Log(int channel, std::string_view text) {
  core_.observers.Notify(Event::kPrint, [&](Observer& o) { o.OnLog(core_.agent, channel, text); });
}

void RuleContext::Trace(int level, std::string_view text) {
  core_.observers.Notify(Event::kPrint, [&](Observer& o) { o.OnTraceText(core_.agent, level, text); });
}

void RuleContext::RequestHalt() {
  core_.run.Halt();
}
void RuleContext::RequestInterrupt() {
  core_.run.InterruptByAction();
}

void RuleContext::WaitMilliseconds(std::int64_t milliseconds) {
  if (milliseconds > 0) std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

std::string RuleContext::Timestamp() {
  const auto now = std::chrono::system_clock::now();
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  const auto milliseconds =
      std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000;
  std::tm local{};
  localtime_r(&seconds, &local);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d %H:%M:%S", &local);
  char text[48];
  std::snprintf(text, sizeof text, "%s.%03d", date, static_cast<int>(milliseconds));
  return text;
}

std::uint64_t RuleContext::DecisionCycle() const {
  return core_.counters.decision_phases;
}
std::uint64_t RuleContext::NextConstantNumber() {
  return next_constant_++;
}

std::string RuleContext::RunCommand(std::string_view line) {
  return core_.command_runner ? core_.command_runner(core_.agent, line) : std::string();
}

bool RuleContext::CallUserFunction(std::string_view name, std::string_view argument, std::string& result) {
  if (!core_.user_functions) return false;
  const Symbol text = core_.symbols.String(argument);
  const Result<Symbol> answer = core_.user_functions(core_.agent, name, {&text, 1});
  if (!answer.ok()) {
    PrintError(answer.error().message + "\n");
    return false;
  }
  if (answer.value()) result = ToString(core_.symbols, answer.value(), false);
  return true;
}

void RuleContext::SlotChildren(Symbol identifier, std::vector<Child>& out) const {
  const WorkingMemory& memory = core_.memory;
  for (SlotId slot = memory.identifier(identifier).slots; slot != SlotId::kNone; slot = memory.slot(slot).next) {
    for (WmeId wme = memory.slot(slot).wmes; wme != WmeId::kNone; wme = memory.record(wme).next) {
      out.push_back({memory.wme(wme).attribute, memory.wme(wme).value});
    }
  }
}

void RuleContext::AllChildren(Symbol identifier, std::vector<Child>& out) const {
  for (const WmeId wme : core_.memory.WmesOf(identifier)) {
    if (core_.memory.wme(wme).acceptable) continue;
    out.push_back({core_.memory.wme(wme).attribute, core_.memory.wme(wme).value, wme});
  }
}

Symbol RuleContext::NewIdentifier(char letter) {
  const GoalLevel level = firing_ == InstantiationId::kNone ? GoalLevel{1} : core_.firing.object_level();
  return core_.memory.NewIdentifier(letter, level);
}

void RuleContext::MakePreference(Symbol identifier, Symbol attribute, Symbol value) {
  if (firing_ == InstantiationId::kNone) return;
  Preference preference;
  preference.id = identifier;
  preference.attribute = attribute;
  preference.value = value;
  preference.o_supported = core_.instantiations[firing_].o_support;
  preference.action = Preference::kNoAction;
  core_.preferences.Make(firing_, preference);
}

void RuleContext::CopyElement(const Child& element, Symbol original, Symbol copy, Symbol attribute, Symbol value) {
  if (firing_ != InstantiationId::kNone) copied_.push_back({element.element, original, copy, attribute, value});
}

void RuleContext::MakeCopies() {
  while (made_copies_ < copied_.size()) {
    const Copied& copied = copied_[made_copies_++];
    MakePreference(copied.copy, copied.attribute, copied.value);
  }
}

bool RuleContext::IsGoal(Symbol identifier) const {
  return core_.memory.identifier(identifier).is_goal;
}

std::uint64_t RuleContext::LongTermIdentifier(Symbol identifier) const {
  const auto linked = core_.memory.long_term_identifiers();
  return identifier.IsIdentifier() && identifier.index() < linked.size() ? linked[identifier.index()] : 0;
}

void RuleContext::LinkToLongTerm(Symbol identifier, std::uint64_t lti) {
  // Actions cannot link to long-term memory: every object counts as absent, even if it exists.
  PrintError("Warning: Long-term memory @" + std::to_string(lti) +
             " does not exist.  Could not link short-term memory " + ToString(core_.symbols, identifier) + ".\n");
}

void RuleContext::SetLearning(Symbol state, bool learn) {
  core_.chunker.SetLearning(state, learn);
}

}  // namespace soarbox::kernel
