// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/longterm/agent_parts.h"
#include "kernel/longterm/memory_module.h"

namespace soarbox::kernel {

/// Long-term memory of one agent: its modules, and the places of the cycle where they are called. A module is made when
/// it is asked for first (by its command); an agent that never does pays one test per place and no memory.
///
/// Modules are called in the order of ModuleKind: semantic memory first, then activation, then episodic memory.
class LongTerm {
 public:
  enum class ModuleKind : std::uint8_t { kSemantic, kActivation, kEpisodic };

  explicit LongTerm(const AgentParts& parts) : parts_(parts) {}
  LongTerm(const LongTerm&) = delete;
  LongTerm& operator=(const LongTerm&) = delete;

  /// The module, or null while nobody has made it.
  MemoryModule* module(ModuleKind kind) const { return modules_[static_cast<std::size_t>(kind)].get(); }
  /// Adds a module. It lives as long as the agent.
  void Attach(ModuleKind kind, std::unique_ptr<MemoryModule> module);
  /// The calls that a module wants from now on.
  void SetHooks(ModuleKind kind, ModuleHooks hooks);
  /// Whether any module wants the call.
  bool Wants(ModuleHook hook) const { return (hooks_ & static_cast<ModuleHooks>(hook)) != 0; }
  bool empty() const { return !any_; }

  // Called by the cycle; each only if Wants(its hook), those after StateRemoved always.
  /// Rules are about to fire; if the agent has long-term memory at all.
  void RulesFire();
  [[gnu::noinline]] void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed);
  void Asserted(PreferenceId preference);
  void AfterElaboration();
  void AfterDecision();
  void Output(bool output_changed);
  void StateMade(GoalLevel level);
  void StateRemoved(GoalLevel level);
  void BeforeInit();
  void AfterInit();
  void Mark(const std::function<void(Symbol)>& mark);
  void IdentifierFreed(Symbol id);
  void ForEachHeld(const std::function<void(PreferenceId)>& visit) const;
  void LinkChanged(Symbol id);
  std::size_t MemoryBytes() const;

  const AgentParts& parts() const { return parts_; }

  /// What ^epmem.present-id of a new state says: the number of the next episode.
  std::int64_t present_id = 1;

 private:
  static constexpr std::size_t kModules = 3;

  template <typename Call>
  void ForEach(ModuleHook hook, Call call);

  AgentParts parts_;
  ModuleHooks hooks_ = 0;  ///< Of all modules.
  bool any_ = false;
  std::array<ModuleHooks, kModules> module_hooks_{};
  std::array<std::unique_ptr<MemoryModule>, kModules> modules_;
};

}  // namespace soarbox::kernel
