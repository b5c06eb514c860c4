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

/// Changes of working memory on their way to the matcher. Elements get their time tags when they are added here; the
/// match hears of them in Flush, newest first and all additions before all removals, as traces and firing orders show.
class WmeChanges {
 public:
  WmeChanges(WorkingMemory& memory, LinkGraph& links, Rete& rete, OutputMarks& output, ElementListener& listener)
      : memory_(memory), links_(links), rete_(rete), output_(output), listener_(listener) {
    for (std::vector<WmeId>* list : {&added_, &removed_, &dead_, &flushing_added_, &flushing_removed_})
      list->reserve(32);
  }

  WmeId Add(WmeKind kind, Symbol id, Symbol attribute, Symbol value, SlotId slot = SlotId::kNone,
            PreferenceId preference = PreferenceId::kNone);
  /// An element from outside, which may pass for that of an acceptable preference.
  WmeId AddInput(Symbol id, Symbol attribute, Symbol value, bool acceptable);
  /// The element of an acceptable preference.
  WmeId AddAcceptable(SlotId slot, Symbol value, PreferenceId preference);
  void Remove(WmeId wme);
  /// Removes an input element and adds one with another constant in its place, for less if no rule tests it: then it
  /// keeps its index, and this is true. Else nothing is done. Not while anybody hears of single elements.
  bool Renew(WmeId wme, Symbol value);
  /// Removes an element because its support went: a goal whose dependency set holds it goes first. (What the
  /// architecture takes back, items and garbage, goes by Remove and costs no goal.)
  void Lose(WmeId wme);
  /// Hands everything to the match.
  [[gnu::flatten]] void Flush();
  bool empty() const { return added_.empty() && removed_.empty(); }
  /// True if Bury would give indices back.
  bool HasDead() const { return !dead_.empty(); }
  /// Removed from memory, and still to be read.
  std::span<const WmeId> dead() const { return dead_; }

  void AddReference(WmeId wme);
  /// Frees an element that has left the match when nothing refers to it any more.
  void DropReference(WmeId wme);
  /// Gives back the indices of removed elements. Only when no retraction is pending, whose elements may be shown.
  [[gnu::flatten]] void Bury();
  /// Whether the listener hears of the attributes of new elements.
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
  std::size_t renewed_ = 0;  ///< So many of added_ stand for one that leaves, too.
  std::vector<WmeId> added_, removed_, dead_, flushing_added_, flushing_removed_;
};

}  // namespace soarbox::kernel
