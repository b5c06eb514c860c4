// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

/// A link from one identifier to another.
struct Link {
  Symbol from, to;
  LinkId next_in, previous_in;        ///< List of links to `to`.
  LinkId next_child, previous_child;  ///< List of parent links from `from`.
};

/// The links between identifiers. Determines the level of each identifier, and which identifiers are garbage.
///
/// A link is a preference in a slot with an identifier as its value (or referent). An element without a preference
/// whose value is an identifier is also a link, unless its kind is kArchitecture. Each identifier that is reachable
/// from a goal has one parent link. The parent links form a tree below every goal; the level of an identifier is that
/// of the goal at its root.
///
/// Removing a link that is not a parent link changes no level. When a parent link is removed, another link to the
/// identifier itself is searched first. Only if there is none, links into the rest of its subtree are searched. So the
/// cost depends on the size of the structure cut off, not on that of working memory.
///
/// Invariants after Settle(): an identifier with a parent link has the level of the link's source. (But an identifier
/// that was not reachable keeps its initial level when a state of a larger level links to it.) Following parent links
/// ends at a goal (or at an identifier that is not reachable from one). No link of an identifier that is reachable from
/// a goal leads from a smaller level to a larger one.
class LinkGraph {
 public:
  explicit LinkGraph(WorkingMemory& memory) : memory_(memory) {}

  /// Both must be live identifiers. Links to goals are not stored: the result is then LinkId::kNone.
  LinkId Add(Symbol from, Symbol to);
  void Remove(LinkId link);

  /// True if links changed in a way that can change levels.
  bool HasWork() const { return restless_; }
  /// Updates the levels of the identifiers that changed. First come promotions. Then come identifiers without links and
  /// removed goals, in the order in which they lost their first link or were removed. Identifiers that only they linked
  /// to follow immediately. Identifiers that may have other links come last.
  /// Appends the identifiers that are no longer reachable from a goal to `garbage`. The caller removes what they own,
  /// which may cause more work: call Settle again until HasWork() is false.
  void Settle(std::vector<Symbol>& garbage);
  /// An element with this value was added or removed. An identifier without links is kept while it is the value of an
  /// element outside garbage. It becomes garbage when the last such element is removed.
  void ElementAdded(Symbol value, bool is_item) {
    ++At(value).value_of;
    At(value).item_of += is_item ? 1 : 0;
  }
  void ElementRemoved(Symbol value, bool is_item);
  /// Makes the identifier of a removed goal garbage. Identifiers that only it linked to follow when it is collected.
  void Discard(Symbol goal) {
    At(goal).gone = true;
    Post(goal);
  }

  void Clear();
  std::size_t MemoryBytes() const;
  /// Returns a description of the first violated invariant, or an empty text.
  std::string CheckInvariants(const SymbolTable& symbols) const;

 private:
  enum class Ancestry : std::uint8_t { kRooted, kBelow, kFloating };

  IdentifierRecord& At(Symbol id) { return memory_.mutable_identifier(id); }
  void NotePromoted(Symbol id) {
    promoted_.push_back(id);
    restless_ = true;
  }
  void Post(Symbol id);
  void SetParent(Symbol id, LinkId link);
  void Root(Symbol id);
  void DropParent(Symbol id);
  /// Follows parent links from `from`. Ends at a goal, at `stop`, or at an identifier without a parent.
  Ancestry Trace(Symbol from, Symbol stop) const;
  void Work(std::vector<Symbol>& garbage);
  void BeginToSettle();
  bool IsHeld(Symbol id) const;
  bool NamesItself(Symbol id) const;
  void Promote(Symbol id);
  bool FindParent(Symbol id);
  void Reattach(std::vector<Symbol>& garbage);
  void Suspend(Symbol id);
  void Rescue();
  void RescueNamed();
  void ListGarbage(std::vector<Symbol>& garbage);
  template <typename Visit>
  void ForEachLinkFrom(Symbol id, Visit visit) const;

  WorkingMemory& memory_;
  RecordArena<Link, &Link::next_in> links_;
  bool restless_ = false;  ///< One of the first four lists is not empty, or Settle has not finished.
  bool settling_ = false;
  std::vector<Symbol> promoted_;
  std::vector<Symbol> posted_;     ///< Identifiers that lost a link, and removed goals, in order, until Settle.
  std::vector<Symbol> unheld_;     ///< During Settle: identifiers without links; the last one is next.
  std::vector<Symbol> uncertain_;  ///< During Settle: identifiers that lost a link and may have others, in order.
  std::vector<Symbol> gone_;       ///< During Settle: removed goals that have been processed.
  std::vector<Symbol> roots_;      ///< During Reattach: identifiers without a parent, the newest loss first.
  std::vector<Symbol> subtree_;    ///< During Reattach: these with their subtrees.
  /// By identifier index: not 0 if the identifier is in `subtree_` and not rescued. The value minus 1 is the number of
  /// elements that have it as their value. Items are not counted, and neither are elements that were found to belong to
  /// the subtree or to a removed goal.
  std::vector<std::uint32_t> suspended_;
  std::vector<Symbol> stack_;
  struct Candidate {
    GoalLevel level;
    LinkId link;
  };
  std::vector<Candidate> heap_;
};

}  // namespace soarbox::kernel
