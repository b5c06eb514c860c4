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

/// One way from an identifier to another.
struct Link {
  Symbol from, to;
  LinkId next_in, previous_in;        ///< Links to `to`.
  LinkId next_child, previous_child;  ///< Parent links from `from`.
};

/// Which identifiers hang on which goals: the links between identifiers, the level that each identifier has, and what
/// is garbage.
///
/// A link is a preference in a slot whose value (or referent) is an identifier, or an element of the architecture or of
/// input whose value is one. Each identifier that a goal reaches has one parent link; the parent links form a tree
/// under every goal, and the level of an identifier is that of the goal at the root. Removing any other link changes
/// nothing. Removing a parent link looks for another way in, first among the links that lead to the identifier itself,
/// and only then for the rest of the tree below it. So the cost is that of the structure cut off, never that of working
/// memory.
///
/// Invariants, after Settle(): an identifier with a parent link has the level of the link's source, and following
/// parents ends at a goal (or at an identifier that was never linked); no link leads from a smaller level to a larger
/// one.
class LinkGraph {
 public:
  explicit LinkGraph(WorkingMemory& memory) : memory_(memory) {}

  /// Both must be identifiers that live; links to goals are not kept (the result is then LinkId::kNone).
  LinkId Add(Symbol from, Symbol to);
  void Remove(LinkId link);

  /// True if links changed in a way that can move levels.
  bool HasWork() const { return restless_; }
  /// Works out the levels of the identifiers that changed: promotions first, then what no link holds and goals that
  /// have gone, in the order in which they lost their first link or went; what only garbage held follows it at once.
  /// Identifiers that other links may still hold come last. Those that no goal reaches any more are appended to
  /// `garbage`; the caller removes what they own, which may make more work: call again until HasWork() is false.
  void Settle(std::vector<Symbol>& garbage);
  /// Elements with this value come and go. An identifier that elements of others than garbage still name is not garbage
  /// yet, though the links are gone: its turn comes when the last of them goes.
  void ElementAdded(Symbol value, bool is_item) {
    ++At(value).value_of;
    At(value).item_of += is_item ? 1 : 0;
  }
  void ElementRemoved(Symbol value, bool is_item);
  /// Makes the identifier of a goal that has gone garbage. What hangs on it follows when it is collected.
  void Discard(Symbol goal) {
    At(goal).gone = true;
    Post(goal);
  }

  void Clear();
  std::size_t MemoryBytes() const;
  /// The first violation of the class's invariants in words, or empty.
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
  /// Where following parents from `from` ends: at a goal, at (or through) `stop`, or nowhere.
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
  bool restless_ = false;  ///< One of the first four is not empty, or settling has not come to its end.
  bool settling_ = false;
  std::vector<Symbol> promoted_;
  std::vector<Symbol> posted_;     ///< What lost a link, and goals that have gone, in order, until links settle.
  std::vector<Symbol> unheld_;     ///< While they settle: what no link holds; the last one is the next.
  std::vector<Symbol> uncertain_;  ///< While they settle: what lost a link and may have others, in order.
  std::vector<Symbol> gone_;       ///< While they settle: goals that have gone and have had their turn.
  std::vector<Symbol> roots_;      ///< While Reattach works: what has no parent any more, the newest loss first,
  std::vector<Symbol> subtree_;    ///< and with all that hangs on it.
  /// By identifier index: not 0 if it is in `subtree_` and not rescued; the others that name it are counted above 1.
  std::vector<std::uint32_t> suspended_;
  std::vector<Symbol> stack_;
  struct Candidate {
    GoalLevel level;
    LinkId link;
  };
  std::vector<Candidate> heap_;
};

}  // namespace soarbox::kernel
