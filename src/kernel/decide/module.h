// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

struct Candidate;
class Production;

/// The calls that a module can request. An agent without modules makes none of them.
enum class ModuleHook : std::uint32_t {
  kRulesFire = 1u << 0,         ///< Before rules fire and matches are retracted.
  kFlush = 1u << 1,             ///< Elements of working memory were added and removed.
  kAfterElaboration = 1u << 2,  ///< An elaboration has ended; its changes have been matched.
  kChoices = 1u << 3,           ///< Operators are selected and installed.
  kAfterDecision = 1u << 4,     ///< Near the end of the decide phase; the decision line has been traced.
  kOutput = 1u << 5,            ///< The output phase, after the output link was read.
  kOutputEnd = 1u << 6,         ///< In the output phase, after all modules received kOutput.
  kStates = 1u << 7,            ///< States are created and removed.
  kMatches = 1u << 8,           ///< Matches end.
  kHalt = 1u << 9,              ///< A rule halts the agent, or the goal stack limit ends the run.
  kIdentifiers = 1u << 10,      ///< Identifiers are freed, or linked to long-term identifiers.
  kAttributes = 1u << 11,       ///< Elements are created. Also requires WmeChanges::TellOfAttributes(true).
  kAsserted = 1u << 12,         ///< A rule's preference entered its slot.
  kInput = 1u << 13,            ///< In the input phase, before the input link is applied.
};
using ModuleHooks = std::uint32_t;
constexpr ModuleHooks operator|(ModuleHook a, ModuleHook b) {
  return static_cast<ModuleHooks>(a) | static_cast<ModuleHooks>(b);
}
constexpr ModuleHooks operator|(ModuleHooks a, ModuleHook b) {
  return a | static_cast<ModuleHooks>(b);
}

/// A mechanism that takes part in the decision cycle without being a fixed part of it: semantic memory, episodic
/// memory, activation of working memory, reinforcement learning, and most of chunking. Override the functions that you
/// need and request their hooks with Modules::SetHooks (modules.h); no hook is requested initially.
///
/// A module may change working memory only in Input, AfterElaboration, AfterDecision, Output and OutputEnd, through
/// PreferenceChanges, WmeChanges or, in long-term memory, Installer. In StateComplete it may add elements. It may
/// excise rules only in OutputEnd. No function may throw.
class Module {
 public:
  virtual ~Module() = default;

  virtual void Input() {}
  virtual void RulesFire() {}
  /// Elements that were added (and matched already) and removed, in the order of the changes. An element that was added
  /// and removed within a phase is in both lists. The contents of removed elements are readable until the call returns.
  virtual void Flushed(std::span<const WmeId> /*added*/, std::span<const WmeId> /*removed*/) {}
  /// A preference entered its slot; the slot has not been decided yet.
  virtual void Asserted(PreferenceId /*preference*/) {}
  virtual void AfterElaboration() {}
  /// A match of a fired rule no longer exists. `rule` is kNone for the match of a justification.
  virtual void MatchEnded(ProductionId /*rule*/) {}
  /// An operator is selected, without an impasse. Called before the states below are removed.
  virtual void OperatorChosen(GoalLevel /*level*/, std::span<const Candidate> /*candidates*/,
                              const Candidate& /*winner*/) {}
  /// The selected operator is in its slot.
  virtual void OperatorInstalled(GoalLevel /*level*/, Symbol /*op*/) {}
  virtual void AfterDecision() {}
  /// `output_changed`: rules changed something below the output link in this cycle.
  virtual void Output(bool /*output_changed*/) {}
  virtual void OutputEnd() {}
  virtual void Halted() {}
  /// The state has its links (Goal::smem, Goal::epmem), but its elements are not in the match yet.
  virtual void StateMade(GoalLevel /*level*/) {}
  /// A substate has all elements that the architecture creates. (For the top state see AfterInit.) A module may add
  /// elements.
  virtual void StateComplete(GoalLevel /*level*/) {}
  /// The items of a substate's impasse were created, by `firings` firings of the architecture.
  virtual void ItemsMade(std::uint32_t /*firings*/) {}
  /// A new item. `index` identifies one of the firings that the last ItemsMade reported.
  virtual void ItemMade(WmeId /*item*/, std::uint32_t /*index*/) {}
  /// The state is about to be removed; it is still complete. Init-soar calls it for substates only.
  virtual void StateEnds(GoalLevel /*level*/) {}
  /// The state was removed, and the preferences of its instantiations were retracted: release references to them.
  virtual void StateRemoved(GoalLevel /*level*/) {}
  /// An element with this attribute was created.
  virtual void AttributeUsed(Symbol /*attribute*/) {}
  /// A sweep frees this identifier. Its index will be reused.
  virtual void IdentifierFreed(Symbol /*id*/) {}
  /// An identifier of working memory is now linked to another long-term identifier, or to none.
  virtual void LinkChanged(Symbol /*id*/) {}

  // Called always, without hooks.
  /// init-soar begins (everything is still there), or the agent is being created.
  virtual void BeforeInit() {}
  /// Working memory contains only the new top state. All earlier identifiers, elements and preferences are gone.
  virtual void AfterInit() {}
  virtual void RuleAdded(ProductionId /*rule*/, const Production& /*production*/) {}
  /// Called before the rule is removed.
  virtual void RuleExcised(ProductionId /*rule*/) {}
  /// A sweep: call `mark` for each symbol that the module refers to. Unmarked constants and identifiers are freed.
  virtual void Mark(const std::function<void(Symbol)>& /*mark*/) {}
  /// Calls `visit` for each preference that the module has a reference to. For checks.
  virtual void ForEachHeld(const std::function<void(PreferenceId)>& /*visit*/) const {}
  virtual std::size_t MemoryBytes() const { return 0; }
};

}  // namespace soarbox::kernel
