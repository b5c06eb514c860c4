// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/long_term.h"

#include <utility>

#include "kernel/longterm/wm_activation.h"

namespace soarbox::kernel {

void LongTerm::Attach(ModuleKind kind, std::unique_ptr<MemoryModule> module) {
  modules_[static_cast<std::size_t>(kind)] = std::move(module);
  any_ = true;
}

void LongTerm::SetHooks(ModuleKind kind, ModuleHooks hooks) {
  module_hooks_[static_cast<std::size_t>(kind)] = hooks;
  hooks_ = 0;
  for (const ModuleHooks of_module : module_hooks_) hooks_ |= of_module;
}

template <typename Call>
void LongTerm::ForEach(ModuleHook hook, Call call) {
  for (std::size_t n = 0; n < kModules; ++n) {
    if ((module_hooks_[n] & static_cast<ModuleHooks>(hook)) != 0) call(*modules_[n]);
  }
}

void LongTerm::RulesFire() {
  WmActivation::RulesFire(*this);
}

void LongTerm::Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) {
  ForEach(ModuleHook::kFlush, [&](MemoryModule& module) { module.Flushed(added, removed); });
}

void LongTerm::Asserted(PreferenceId preference) {
  ForEach(ModuleHook::kAsserted, [&](MemoryModule& module) { module.Asserted(preference); });
}

void LongTerm::AfterElaboration() {
  ForEach(ModuleHook::kAfterElaboration, [](MemoryModule& module) { module.AfterElaboration(); });
}

void LongTerm::AfterDecision() {
  ForEach(ModuleHook::kAfterDecision, [](MemoryModule& module) { module.AfterDecision(); });
}

void LongTerm::Output(bool output_changed) {
  ForEach(ModuleHook::kOutput, [&](MemoryModule& module) { module.Output(output_changed); });
  ForEach(ModuleHook::kOutputEnd, [](MemoryModule& module) { module.OutputEnd(); });
}

void LongTerm::StateMade(GoalLevel level) {
  ForEach(ModuleHook::kStates, [&](MemoryModule& module) { module.StateMade(level); });
}

void LongTerm::StateRemoved(GoalLevel level) {
  ForEach(ModuleHook::kStates, [&](MemoryModule& module) { module.StateRemoved(level); });
}

void LongTerm::BeforeInit() {
  for (const auto& module : modules_) {
    if (module != nullptr) module->BeforeInit();
  }
}

void LongTerm::AfterInit() {
  for (const auto& module : modules_) {
    if (module != nullptr) module->AfterInit();
  }
}

void LongTerm::Mark(const std::function<void(Symbol)>& mark) {
  for (const auto& module : modules_) {
    if (module != nullptr) module->Mark(mark);
  }
}

void LongTerm::IdentifierFreed(Symbol id) {
  for (const auto& module : modules_) {
    if (module != nullptr) module->IdentifierFreed(id);
  }
}

void LongTerm::ForEachHeld(const std::function<void(PreferenceId)>& visit) const {
  for (const auto& module : modules_) {
    if (module != nullptr) module->ForEachHeld(visit);
  }
}

void LongTerm::LinkChanged(Symbol id) {
  for (const auto& module : modules_) {
    if (module != nullptr) module->LinkChanged(id);
  }
}

std::size_t LongTerm::MemoryBytes() const {
  std::size_t bytes = 0;
  for (const auto& module : modules_) {
    if (module != nullptr) bytes += module->MemoryBytes();
  }
  return bytes;
}

}  // namespace soarbox::kernel
