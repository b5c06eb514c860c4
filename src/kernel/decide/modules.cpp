// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/modules.h"

#include <algorithm>

namespace soarbox::kernel {

void Modules::Attach(Module& module, int place) {
  const auto next = std::ranges::find_if(modules_, [&](const Attached& attached) { return attached.place > place; });
  modules_.insert(next, {&module, place, 0});
}

void Modules::SetHooks(const Module& module, ModuleHooks hooks) {
  hooks_ = 0;
  for (Attached& attached : modules_) {
    if (attached.module == &module) attached.hooks = hooks;
    hooks_ |= attached.hooks;
  }
}

template <typename Call>
void Modules::ForEach(ModuleHook hook, Call call) {
  for (const Attached& attached : modules_) {
    if ((attached.hooks & static_cast<ModuleHooks>(hook)) != 0) call(*attached.module);
  }
}

// Calls with a hook ---------------------------------------------------------------------------------------------------

void Modules::Input() {
  ForEach(ModuleHook::kInput, [](Module& module) { module.Input(); });
}

void Modules::RulesFire() {
  ForEach(ModuleHook::kRulesFire, [](Module& module) { module.RulesFire(); });
}

void Modules::Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) {
  ForEach(ModuleHook::kFlush, [&](Module& module) { module.Flushed(added, removed); });
}

void Modules::Asserted(PreferenceId preference) {
  ForEach(ModuleHook::kAsserted, [&](Module& module) { module.Asserted(preference); });
}

void Modules::AfterElaboration() {
  ForEach(ModuleHook::kAfterElaboration, [](Module& module) { module.AfterElaboration(); });
}

void Modules::MatchEnded(ProductionId rule) {
  ForEach(ModuleHook::kMatches, [&](Module& module) { module.MatchEnded(rule); });
}

void Modules::OperatorChosen(GoalLevel level, std::span<const Candidate> candidates, const Candidate& winner) {
  ForEach(ModuleHook::kChoices, [&](Module& module) { module.OperatorChosen(level, candidates, winner); });
}

void Modules::OperatorInstalled(GoalLevel level, Symbol op) {
  ForEach(ModuleHook::kChoices, [&](Module& module) { module.OperatorInstalled(level, op); });
}

void Modules::AfterDecision() {
  ForEach(ModuleHook::kAfterDecision, [](Module& module) { module.AfterDecision(); });
}

void Modules::Output(bool output_changed) {
  ForEach(ModuleHook::kOutput, [&](Module& module) { module.Output(output_changed); });
}

void Modules::OutputEnd() {
  ForEach(ModuleHook::kOutputEnd, [](Module& module) { module.OutputEnd(); });
}

void Modules::Halted() {
  ForEach(ModuleHook::kHalt, [](Module& module) { module.Halted(); });
}

void Modules::StateMade(GoalLevel level) {
  ForEach(ModuleHook::kStates, [&](Module& module) { module.StateMade(level); });
}

void Modules::StateComplete(GoalLevel level) {
  ForEach(ModuleHook::kStates, [&](Module& module) { module.StateComplete(level); });
}

void Modules::ItemsMade(std::uint32_t firings) {
  ForEach(ModuleHook::kStates, [&](Module& module) { module.ItemsMade(firings); });
}

void Modules::ItemMade(WmeId item, std::uint32_t index) {
  ForEach(ModuleHook::kStates, [&](Module& module) { module.ItemMade(item, index); });
}

void Modules::StateEnds(GoalLevel level) {
  ForEach(ModuleHook::kStates, [&](Module& module) { module.StateEnds(level); });
}

void Modules::StateRemoved(GoalLevel level) {
  ForEach(ModuleHook::kStates, [&](Module& module) { module.StateRemoved(level); });
}

void Modules::AttributeUsed(Symbol attribute) {
  ForEach(ModuleHook::kAttributes, [&](Module& module) { module.AttributeUsed(attribute); });
}

void Modules::IdentifierFreed(Symbol id) {
  ForEach(ModuleHook::kIdentifiers, [&](Module& module) { module.IdentifierFreed(id); });
}

void Modules::LinkChanged(Symbol id) {
  ForEach(ModuleHook::kIdentifiers, [&](Module& module) { module.LinkChanged(id); });
}

// Calls without a hook ------------------------------------------------------------------------------------------------

void Modules::BeforeInit() {
  for (const Attached& attached : modules_) attached.module->BeforeInit();
}

void Modules::AfterInit() {
  for (const Attached& attached : modules_) attached.module->AfterInit();
}

void Modules::RuleAdded(ProductionId rule, const Production& production) {
  for (const Attached& attached : modules_) attached.module->RuleAdded(rule, production);
}

void Modules::RuleExcised(ProductionId rule) {
  for (const Attached& attached : modules_) attached.module->RuleExcised(rule);
}

void Modules::Mark(const std::function<void(Symbol)>& mark) {
  for (const Attached& attached : modules_) attached.module->Mark(mark);
}

void Modules::ForEachHeld(const std::function<void(PreferenceId)>& visit) const {
  for (const Attached& attached : modules_) attached.module->ForEachHeld(visit);
}

std::size_t Modules::MemoryBytes() const {
  std::size_t bytes = 0;
  for (const Attached& attached : modules_) bytes += attached.module->MemoryBytes();
  return bytes;
}

}  // namespace soarbox::kernel
