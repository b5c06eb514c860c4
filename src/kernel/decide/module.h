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

/// Where a module is called. A module gets the calls that it asked for, and an agent without modules makes none.
enum class ModuleHook : std::uint32_t {
  kRulesFire = 1u << 0,         ///< Rules are about to fire, and matches about to be retracted.
  kFlush = 1u << 1,             ///< Elements of working memory came and went.
  kAfterElaboration = 1u << 2,  ///< An elaboration is over; its changes have been matched.
  kChoices = 1u << 3,           ///< Operators are chosen and installed.
  kAfterDecision = 1u << 4,     ///< The decide phase is over but for its end; the decision line has been traced.
  kOutput = 1u << 5,            ///< The output phase, after the output link was read.
  kOutputEnd = 1u << 6,         ///< The same, when all modules have had kOutput.
  kStates = 1u << 7,            ///< States come and go.
  kMatches = 1u << 8,           ///< Matches end.
  kHalt = 1u << 9,              ///< A rule halts the agent, or too many goals end the run.
  kIdentifiers = 1u << 10,      ///< Identifiers are freed, or linked to long-term ones.
  kAttributes = 1u << 11,       ///< Elements are made; ask WmeChanges::TellOfAttributes for them, too.
  kAsserted = 1u << 12,         ///< A rule's preference entered its slot.
  kInput = 1u << 13,            ///< The input phase, before the input link.
};
using ModuleHooks = std::uint32_t;
constexpr ModuleHooks operator|(ModuleHook a, ModuleHook b) {
  return static_cast<ModuleHooks>(a) | static_cast<ModuleHooks>(b);
}
constexpr ModuleHooks operator|(ModuleHooks a, ModuleHook b) {
  return a | static_cast<ModuleHooks>(b);
}

/// A mechanism that takes part in the decision cycle without being part of it: semantic memory, episodic memory,
/// activation of working memory, reinforcement learning, and most of chunking. Override what you need, and ask for the
/// hooks with Modules::SetHooks (modules.h): none are called before that.
///
/// A module may change working memory in Input, AfterElaboration, AfterDecision, Output and OutputEnd, through
/// PreferenceChanges or, in long-term memory, Installer; rules may go in OutputEnd. In the others it only takes notes.
/// Nothing here may throw.
class Module {
 public:
  virtual ~Module() = default;

  virtual void Input() {}
  virtual void RulesFire() {}
  /// What came (in the match already) and went, in the order of the changes. An element that came and went within a
  /// phase is on both lists. The contents of removed elements are readable until the call returns.
  virtual void Flushed(std::span<const WmeId> /*added*/, std::span<const WmeId> /*removed*/) {}
  /// The slot has not been decided yet.
  virtual void Asserted(PreferenceId /*preference*/) {}
  virtual void AfterElaboration() {}
  /// A match of a rule that fired holds no more. kNone: it was a justification's.
  virtual void MatchEnded(ProductionId /*rule*/) {}
  /// The decision procedure has a winner, and no impasse. Before states below go.
  virtual void OperatorChosen(GoalLevel /*level*/, std::span<const Candidate> /*candidates*/,
                              const Candidate& /*winner*/) {}
  /// The winner stands in its slot.
  virtual void OperatorInstalled(GoalLevel /*level*/, Symbol /*op*/) {}
  virtual void AfterDecision() {}
  /// `output_changed`: rules changed what hangs on the output link in this cycle.
  virtual void Output(bool /*output_changed*/) {}
  virtual void OutputEnd() {}
  virtual void Halted() {}
  /// The state has its links (Goal::smem, Goal::epmem), but its elements are not in the match yet.
  virtual void StateMade(GoalLevel /*level*/) {}
  /// The state has all that the architecture gives a new substate. (The top state: see AfterInit.) A module may add to
  /// it.
  virtual void StateComplete(GoalLevel /*level*/) {}
  /// The impasse of a substate got its items: `firings` in number, each of which counts as one.
  virtual void ItemsMade(std::uint32_t /*firings*/) {}
  /// An item that was not there before; `index` of the firings that ItemsMade told of last.
  virtual void ItemMade(WmeId /*item*/, std::uint32_t /*index*/) {}
  /// The state is about to go; everything is still there. Not called by init-soar.
  virtual void StateEnds(GoalLevel /*level*/) {}
  /// The preferences of the state's instantiations have been taken back already: forget them.
  virtual void StateRemoved(GoalLevel /*level*/) {}
  /// An element with this attribute was made.
  virtual void AttributeUsed(Symbol /*attribute*/) {}
  /// A sweep frees this identifier: its index will name another one.
  virtual void IdentifierFreed(Symbol /*id*/) {}
  /// An identifier of working memory is linked to another long-term identifier now, or to none.
  virtual void LinkChanged(Symbol /*id*/) {}

  // Called always, hooks or not.
  /// init-soar begins: everything is still there. Or the agent is being made.
  virtual void BeforeInit() {}
  /// Working memory is empty but for the new top state: identifiers, elements and preferences of old are gone.
  virtual void AfterInit() {}
  virtual void RuleAdded(ProductionId /*rule*/, const Production& /*production*/) {}
  /// The rule is about to go.
  virtual void RuleExcised(ProductionId /*rule*/) {}
  /// A sweep: call `mark` for each symbol that you hold. Constants that nobody marks are freed, and so are identifiers.
  virtual void Mark(const std::function<void(Symbol)>& /*mark*/) {}
  /// Calls `visit` for each preference that you hold a reference on. For checks.
  virtual void ForEachHeld(const std::function<void(PreferenceId)>& /*visit*/) const {}
  virtual std::size_t MemoryBytes() const { return 0; }
};

}  // namespace soarbox::kernel
