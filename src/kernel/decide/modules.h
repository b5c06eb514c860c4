// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "kernel/decide/module.h"

namespace soarbox::kernel {

/// The modules of one agent. The decision cycle calls Wants before each call that has a hook, so that calls without a
/// subscriber cost one test.
class Modules {
 public:
  /// The place of a module that is called after all others.
  static constexpr int kLast = 255;

  Modules() = default;
  Modules(const Modules&) = delete;
  Modules& operator=(const Modules&) = delete;

  /// Adds a module, which must outlive the agent's runs. Modules are called in ascending order of their places.
  void Attach(Module& module, int place);
  /// Sets the hooks that an attached module receives from now on.
  void SetHooks(const Module& module, ModuleHooks hooks);
  /// Whether any module wants the call.
  bool Wants(ModuleHook hook) const { return (hooks_ & static_cast<ModuleHooks>(hook)) != 0; }

  // The functions of Module; each calls the modules that requested it.
  [[gnu::noinline]] void Input();
  [[gnu::noinline]] void RulesFire();
  [[gnu::noinline]] void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed);
  void Asserted(PreferenceId preference);
  void AfterElaboration();
  [[gnu::noinline]] void MatchEnded(ProductionId rule);
  void OperatorChosen(GoalLevel level, std::span<const Candidate> candidates, const Candidate& winner);
  void OperatorInstalled(GoalLevel level, Symbol op);
  void AfterDecision();
  void Output(bool output_changed);
  void OutputEnd();
  void Halted();
  void StateMade(GoalLevel level);
  void StateComplete(GoalLevel level);
  void ItemsMade(std::uint32_t firings);
  void ItemMade(WmeId item, std::uint32_t index);
  void StateEnds(GoalLevel level);
  void StateRemoved(GoalLevel level);
  void AttributeUsed(Symbol attribute);
  void IdentifierFreed(Symbol id);
  void LinkChanged(Symbol id);
  void BeforeInit();
  void AfterInit();
  void RuleAdded(ProductionId rule, const Production& production);
  void RuleExcised(ProductionId rule);
  void Mark(const std::function<void(Symbol)>& mark);
  void ForEachHeld(const std::function<void(PreferenceId)>& visit) const;
  std::size_t MemoryBytes() const;

 private:
  struct Attached {
    Module* module = nullptr;
    int place = 0;
    ModuleHooks hooks = 0;
  };
  template <typename Call>
  void ForEach(ModuleHook hook, Call call);

  std::vector<Attached> modules_;  ///< In the order of their places.
  ModuleHooks hooks_ = 0;          ///< The union of the hooks of all modules.
};

}  // namespace soarbox::kernel
