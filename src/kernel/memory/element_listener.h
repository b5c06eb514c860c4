// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// What WmeChanges tells the rest of the agent of elements that come and go. The match and the links hear of all of
/// them directly; these calls are for what few elements, or few agents, need.
class ElementListener {
 public:
  virtual ~ElementListener() = default;

  // When an element is made or removed, before the match hears of it.
  /// Only after WmeChanges::TellOfAttributes(true): an element with this attribute was made.
  virtual void AttributeUsed(Symbol attribute) = 0;
  /// The support of a member of a goal's dependency set goes: the goal goes first.
  virtual void DependencyLost(WmeId wme) = 0;
  /// A member of such a set is removed for another reason; goals stay.
  virtual void DependencyForgotten(WmeId wme) = 0;
  /// An element that the input link made is removed. `element`: WmeRecord::input_element().
  virtual void InputElementRemoved(std::uint32_t element) = 0;

  // While changes go to the match.
  /// They are about to. True: Entered and Left are to be called for each element. May throw std::bad_alloc: then
  /// nothing goes to the match.
  virtual bool FlushBegins(std::size_t added, std::size_t removed) = 0;
  /// An element came and went within the phase and was the first to be added; told only if FlushBegins gave true.
  virtual void FirstWasLost(WmeId wme) = 0;
  virtual void Entered(WmeId wme) = 0;
  virtual void Left(WmeId wme) = 0;
  /// A rule that interrupts the run has begun to match.
  virtual void RuleInterrupts() = 0;
  /// All has been matched. The contents of removed elements are readable until this returns.
  virtual void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) = 0;
};

}  // namespace soarbox::kernel
