// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// Is informed by WmeChanges of elements that are added and removed. WmeChanges informs the match and the links of all
/// elements directly. The calls here are for events that are rare or that few agents need.
class ElementListener {
 public:
  virtual ~ElementListener() = default;

  // Called when an element is created or removed, before the match is informed of it.
  /// An element with this attribute was created. Called only after WmeChanges::TellOfAttributes(true).
  virtual void AttributeUsed(Symbol attribute) = 0;
  /// A member of a goal dependency set loses its support: the goal must be removed first.
  virtual void DependencyLost(WmeId wme) = 0;
  /// A member of a goal dependency set is removed for another reason; goals stay.
  virtual void DependencyForgotten(WmeId wme) = 0;
  /// An element that the input link created is removed. `element`: WmeRecord::input_element().
  virtual void InputElementRemoved(std::uint32_t element) = 0;

  // Called while changes are passed to the match.
  /// The changes are about to be passed on. Returns true if Entered and Left are to be called for each element. May
  /// throw std::bad_alloc: then nothing is passed on.
  virtual bool FlushBegins(std::size_t added, std::size_t removed) = 0;
  /// The newest added element was removed within the same phase. Called only if FlushBegins returned true.
  virtual void FirstWasLost(WmeId wme) = 0;
  /// Called for each added element, also for one that was removed within the same phase.
  virtual void Entered(WmeId wme) = 0;
  virtual void Left(WmeId wme) = 0;
  /// A rule that interrupts the run has a new match.
  virtual void RuleInterrupts() = 0;
  /// Everything has been matched. The contents of removed elements are readable until this returns.
  virtual void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) = 0;
};

}  // namespace soarbox::kernel
