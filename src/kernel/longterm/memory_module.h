// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// Where a module is called. A module gets the calls that it asked for, and an agent without modules makes none.
enum class ModuleHook : std::uint32_t {
  kFlush = 1u << 0,             ///< Elements of working memory came and went.
  kAfterElaboration = 1u << 1,  ///< An elaboration is over; its changes have been matched.
  kAfterDecision = 1u << 2,     ///< The decide phase is over but for its end; the decision line has been traced.
  kOutput = 1u << 3,            ///< The output phase, after the output link was read.
  kOutputEnd = 1u << 4,         ///< The same, when all modules have had kOutput.
  kStates = 1u << 5,            ///< States come and go.
  kAsserted = 1u << 6,          ///< A rule's preference entered its slot.
};
using ModuleHooks = std::uint32_t;
constexpr ModuleHooks operator|(ModuleHook a, ModuleHook b) {
  return static_cast<ModuleHooks>(a) | static_cast<ModuleHooks>(b);
}
constexpr ModuleHooks operator|(ModuleHooks a, ModuleHook b) {
  return a | static_cast<ModuleHooks>(b);
}

/// A part of long-term memory that takes part in the decision cycle: semantic memory, episodic memory, activation of
/// working memory. Override what you need, and ask for the hooks with LongTerm::SetHooks: none are called before.
///
/// A module may change working memory in kAfterElaboration, kAfterDecision, kOutput and kOutputEnd, through Installer
/// (longterm/installer.h) or PreferenceChanges; it calls Installer::Settle when it has. In the others it only takes
/// notes. Nothing here may throw.
class MemoryModule {
 public:
  virtual ~MemoryModule() = default;

  /// What came (in the match already) and went, in the order of the changes. An element that came and went within a
  /// phase is on both lists. The contents of removed elements are readable until the call returns.
  virtual void Flushed(std::span<const WmeId> /*added*/, std::span<const WmeId> /*removed*/) {}
  /// The slot has not been decided yet.
  virtual void Asserted(PreferenceId /*preference*/) {}
  virtual void AfterElaboration() {}
  virtual void AfterDecision() {}
  /// `output_changed`: rules changed what hangs on the output link in this cycle.
  virtual void Output(bool /*output_changed*/) {}
  virtual void OutputEnd() {}
  /// The state has its links (Goal::smem, Goal::epmem), but its elements are not in the match yet.
  virtual void StateMade(GoalLevel /*level*/) {}
  /// The preferences of the state's instantiations have been taken back already: forget them.
  virtual void StateRemoved(GoalLevel /*level*/) {}

  // Called always, hooks or not.
  /// init-soar begins: everything is still there. Or the agent is being made.
  virtual void BeforeInit() {}
  /// Working memory is empty but for the new top state: identifiers, elements and preferences of old are gone.
  virtual void AfterInit() {}
  /// A sweep: call `mark` for each symbol that you hold. Constants that nobody marks are freed, and so are identifiers.
  virtual void Mark(const std::function<void(Symbol)>& /*mark*/) {}
  /// A sweep frees this identifier: its index will name another one.
  virtual void IdentifierFreed(Symbol /*id*/) {}
  /// Calls `visit` for each preference that you hold a reference on (what Installer::Install gave you). For checks.
  virtual void ForEachHeld(const std::function<void(PreferenceId)>& /*visit*/) const {}
  /// An identifier of working memory is linked to another long-term identifier now, or to none.
  virtual void LinkChanged(Symbol /*id*/) {}
  virtual std::size_t MemoryBytes() const { return 0; }
};

}  // namespace soarbox::kernel
