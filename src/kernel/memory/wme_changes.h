// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/match/rete.h"
#include "kernel/memory/element_listener.h"
#include "kernel/memory/links.h"
#include "kernel/memory/output_marks.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

/// The changes of working memory that the matcher has not received yet. Elements get their time tags when they are
/// added here. Flush passes them to the match, newest first and all additions before all removals; Soar's traces and
/// firing orders show this order.
class WmeChanges {
 public:
  WmeChanges(WorkingMemory& memory, LinkGraph& links, Rete& rete, OutputMarks& output, ElementListener& listener)
      : memory_(memory), links_(links), rete_(rete), output_(output), listener_(listener) {
    for (std::vector<WmeId>* list : {&added_, &removed_, &dead_, &flushing_added_, &flushing_removed_})
      list->reserve(32);
  }

  WmeId Add(WmeKind kind, Symbol id, Symbol attribute, Symbol value, SlotId slot = SlotId::kNone,
            PreferenceId preference = PreferenceId::kNone);
  /// Adds an element for a client. With `acceptable`, it looks like the element of an acceptable preference.
  WmeId AddInput(Symbol id, Symbol attribute, Symbol value, bool acceptable);
  /// Adds the element of an acceptable preference.
  WmeId AddAcceptable(SlotId slot, Symbol value, PreferenceId preference);
  void Remove(WmeId wme);
  /// If no rule tests an input element, replaces it by one with another constant and returns true. This costs less than
  /// Lose and Add, because the element keeps its index. Else does nothing and returns false. Must not be called while
  /// an observer wants individual elements. Without Renew, agents that perceive many others (strollers) take 13 % more
  /// instructions. input_link_test.cpp compares both ways with random input.
  bool Renew(WmeId wme, Symbol value);
  /// Removes an element that lost its support. If it is in a goal dependency set, the goal is removed first. (Elements
  /// that the architecture removes, such as items and garbage, are removed by Remove, which affects no goal.)
  void Lose(WmeId wme);
  /// Passes all changes to the match.
  [[gnu::flatten]] void Flush();
  bool empty() const { return added_.empty() && removed_.empty(); }
  /// True if Bury would free indices.
  bool HasDead() const { return !dead_.empty(); }
  /// Elements that were removed from memory but are still readable.
  std::span<const WmeId> dead() const { return dead_; }

  void AddReference(WmeId wme);
  /// Drops a reference to an element. Frees the element if it has left the match and nothing else refers to it.
  void DropReference(WmeId wme);
  /// Frees the indices of removed elements. Call it only if no retraction is pending, because traces may show the
  /// retraction's elements.
  [[gnu::flatten]] void Bury();
  /// Enables calls of ElementListener::AttributeUsed for new elements.
  void TellOfAttributes(bool tell) { tells_of_attributes_ = tell; }
  void Clear();

 private:
  void Record(WmeId wme, WmeKind kind, Symbol id, Symbol attribute, Symbol value);

  WorkingMemory& memory_;
  LinkGraph& links_;
  Rete& rete_;
  OutputMarks& output_;
  ElementListener& listener_;
  bool tells_of_attributes_ = false;
  std::size_t renewed_ = 0;  ///< Number of elements of added_ that replace a removed one.
  std::vector<WmeId> added_, removed_, dead_, flushing_added_, flushing_removed_;
};

}  // namespace soarbox::kernel
