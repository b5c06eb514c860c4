// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/memory/links.h"

#include <algorithm>
#include <string>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

// Adding and removing -------------------------------------------------------------------------------------------------

LinkId LinkGraph::Add(Symbol from, Symbol to) {
  IdentifierRecord& target = At(to);
  if (target.is_goal) return LinkId::kNone;
  if (from == to) {
    target.names_itself = true;
    return LinkId::kNone;
  }
  const LinkId id = links_.Take();
  Link& link = *id.record;
  link.from = from;
  link.to = to;
  link.next_in = target.first_link;
  if (target.first_link != LinkId::kNone) target.first_link.record->previous_in = id;
  target.first_link = id;

  const IdentifierRecord& source = At(from);
  if (target.parent_link == LinkId::kNone) {
    // If an identifier has just lost its link from a higher level, Settle gives it a new parent and a lower level.
    const bool falls = target.rooted && source.level > target.level;
    // An identifier without children cannot be above `from`.
    if (!falls && (target.first_child == LinkId::kNone || Trace(from, to) != Ancestry::kBelow)) SetParent(to, id);
  }
  if (!target.rooted && (source.rooted || source.is_goal)) {
    if (target.parent_link != id) {
      if (target.parent_link != LinkId::kNone) DropParent(to);
      SetParent(to, id);
    }
    Root(to);
  }
  if (source.level < target.level) NotePromoted(to);
  return id;
}

/// The identifier is now reachable from a goal. So is everything below it that was not reachable before, including
/// cycles.
void LinkGraph::Root(Symbol id) {
  IdentifierRecord& first = At(id);
  first.rooted = true;
  if (first.slots == SlotId::kNone && first.architecture_wmes == WmeId::kNone && first.input_wmes == WmeId::kNone)
    return;
  stack_.push_back(id);
  while (!stack_.empty()) {
    const Symbol current = stack_.back();
    stack_.pop_back();
    ForEachLinkFrom(current, [&](LinkId link) {
      const Symbol target = link.record->to;
      IdentifierRecord& below = At(target);
      if (below.rooted || below.is_goal) return;
      if (below.parent_link != link) {
        if (below.parent_link != LinkId::kNone) DropParent(target);
        SetParent(target, link);
      }
      below.rooted = true;
      if (below.level > memory_.level(current)) NotePromoted(target);
      stack_.push_back(target);
    });
  }
}

void LinkGraph::Remove(LinkId id) {
  if (id == LinkId::kNone) return;
  Link& link = *id.record;
  IdentifierRecord& target = At(link.to);
  const bool was_parent = target.parent_link == id;
  if (was_parent) DropParent(link.to);
  if (link.previous_in != LinkId::kNone) {
    link.previous_in.record->next_in = link.next_in;
  } else {
    target.first_link = link.next_in;
  }
  if (link.next_in != LinkId::kNone) link.next_in.record->previous_in = link.previous_in;
  if (was_parent || memory_.level(link.from) == target.level) Post(link.to);
  links_.Give(id);
}

/// The identifier lost a link or the last element with it as value, or it is a removed goal. The position in the queue
/// is that of the first such loss. But while Settle runs, an identifier that loses its last link is processed
/// immediately.
void LinkGraph::Post(Symbol id) {
  IdentifierRecord& record = At(id);
  restless_ = true;
  if (settling_ && record.first_link == LinkId::kNone) {
    unheld_.push_back(id);
  } else if (!record.queued) {
    (settling_ ? uncertain_ : posted_).push_back(id);
  }
  record.queued = true;
}

void LinkGraph::SetParent(Symbol id, LinkId link_id) {
  At(id).parent_link = link_id;
  Link& link = *link_id.record;
  IdentifierRecord& source = At(link.from);
  link.previous_child = LinkId::kNone;
  link.next_child = source.first_child;
  if (source.first_child != LinkId::kNone) source.first_child.record->previous_child = link_id;
  source.first_child = link_id;
}

void LinkGraph::DropParent(Symbol id) {
  IdentifierRecord& record = At(id);
  Link& link = *record.parent_link.record;
  if (link.previous_child != LinkId::kNone) {
    link.previous_child.record->next_child = link.next_child;
  } else {
    At(link.from).first_child = link.next_child;
  }
  if (link.next_child != LinkId::kNone) link.next_child.record->previous_child = link.previous_child;
  link.next_child = link.previous_child = LinkId::kNone;
  record.parent_link = LinkId::kNone;
}

LinkGraph::Ancestry LinkGraph::Trace(Symbol from, Symbol stop) const {
  for (Symbol id = from;;) {
    if (id == stop) return Ancestry::kBelow;
    const IdentifierRecord& record = memory_.identifier(id);
    if (record.is_goal) return Ancestry::kRooted;
    if (record.parent_link == LinkId::kNone) return Ancestry::kFloating;
    id = record.parent_link.record->from;
  }
}

// Settling ------------------------------------------------------------------------------------------------------------

/// Returns true if the identifier has a link or is the value of any element. That element may belong to garbage, to an
/// impasse (an item), or to the identifier itself. Returns false for removed goals.
inline bool LinkGraph::IsHeld(Symbol id) const {
  const IdentifierRecord& record = memory_.identifier(id);
  if (record.gone) return false;
  return record.first_link != LinkId::kNone || record.value_of != 0 || (record.names_itself && NamesItself(id));
}

inline void LinkGraph::BeginToSettle() {
  settling_ = true;
  for (std::size_t n = posted_.size(); n-- > 0;) {
    (IsHeld(posted_[n]) ? uncertain_ : unheld_).push_back(posted_[n]);
  }
  posted_.clear();
  if (uncertain_.size() > 1) std::reverse(uncertain_.begin(), uncertain_.end());
}

void LinkGraph::Settle(std::vector<Symbol>& garbage) {
  Work(garbage);
  settling_ = restless_ = !garbage.empty();
  if (!settling_) gone_.clear();
}

inline void LinkGraph::Work(std::vector<Symbol>& garbage) {
  for (const Symbol id : promoted_) Promote(id);
  promoted_.clear();
  if (!settling_) BeginToSettle();
  while (!unheld_.empty()) {
    const Symbol id = unheld_.back();
    unheld_.pop_back();
    IdentifierRecord& record = At(id);
    if (!record.queued) continue;  // An outdated entry of an identifier that was processed already.
    if (IsHeld(id)) {
      uncertain_.push_back(id);
      continue;
    }
    record.queued = false;
    if (!record.live) continue;
    if (record.gone && record.level > 1) gone_.push_back(id);  // A top state is removed only with the entire memory.
    record.rooted = false;
    garbage.push_back(id);
    return;
  }
  if (!uncertain_.empty()) Reattach(garbage);
}

bool LinkGraph::NamesItself(Symbol id) const {
  for (SlotId slot = memory_.identifier(id).slots; slot != SlotId::kNone; slot = memory_.slot(slot).next) {
    for (PreferenceId p = memory_.slot(slot).acceptable; p != PreferenceId::kNone;
         p = memory_.preference(p).next_in_slot) {
      if (memory_.preference(p).value == id) return true;
    }
  }
  return false;
}

void LinkGraph::ElementRemoved(Symbol value, bool is_item) {
  IdentifierRecord& record = At(value);
  record.item_of -= is_item ? 1 : 0;
  if (--record.value_of == 0 && !record.is_goal && record.parent_link == LinkId::kNone &&
      record.first_link == LinkId::kNone) {
    Post(value);
  }
}

/// If a link from a higher level leads to the identifier, assigns that level to it and to everything that it reaches.
void LinkGraph::Promote(Symbol id) {
  IdentifierRecord& record = At(id);
  if (!record.live || record.is_goal) return;
  LinkId best;
  GoalLevel level = record.level;
  for (LinkId link = record.first_link; link != LinkId::kNone; link = link.record->next_in) {
    const Symbol from = link.record->from;
    const GoalLevel source_level = memory_.level(from);
    if (source_level >= level) continue;
    const Ancestry ancestry = Trace(from, id);
    if (ancestry == Ancestry::kBelow || (ancestry == Ancestry::kFloating && best != LinkId::kNone)) continue;
    best = link;
    level = source_level;
  }
  if (best == LinkId::kNone) return;
  if (record.parent_link != best) {
    if (record.parent_link != LinkId::kNone) DropParent(id);
    SetParent(id, best);
  }
  record.level = level;
  stack_.push_back(id);
  while (!stack_.empty()) {
    const Symbol current = stack_.back();
    stack_.pop_back();
    ForEachLinkFrom(current, [&](LinkId link) {
      const Symbol target = link.record->to;
      IdentifierRecord& below = At(target);
      if (below.level <= level) return;
      if (below.parent_link != LinkId::kNone) DropParent(target);
      SetParent(target, link);
      below.level = level;
      stack_.push_back(target);
    });
  }
}

/// Finds another link from the identifier's own level.
bool LinkGraph::FindParent(Symbol id) {
  const IdentifierRecord& record = At(id);
  for (LinkId link = record.first_link; link != LinkId::kNone; link = link.record->next_in) {
    const Symbol from = link.record->from;
    if (memory_.level(from) != record.level || Trace(from, id) != Ancestry::kRooted) continue;
    SetParent(id, link);
    return true;
  }
  return false;
}

/// Finds new parents for the uncertain identifiers; removes the structure that only they reach.
void LinkGraph::Reattach(std::vector<Symbol>& garbage) {
  roots_.clear();
  for (std::size_t n = uncertain_.size(); n-- > 0;) {
    const Symbol id = uncertain_[n];
    IdentifierRecord& record = At(id);
    if (!record.queued) continue;
    record.queued = false;
    if (!record.live || record.is_goal || record.parent_link != LinkId::kNone || FindParent(id)) continue;
    roots_.push_back(id);
  }
  uncertain_.clear();
  if (roots_.empty()) return;
  // Suspends everything that is reachable only through them.
  if (suspended_.size() < memory_.identifier_limit()) suspended_.resize(memory_.identifier_limit(), 0);
  subtree_.clear();
  for (const Symbol root : roots_) Suspend(root);
  for (std::size_t next = 0; next < subtree_.size(); ++next) {
    for (LinkId child = At(subtree_[next]).first_child; child != LinkId::kNone; child = child.record->next_child) {
      Suspend(child.record->to);
    }
  }
  Rescue();
  RescueNamed();
  ListGarbage(garbage);
}

void LinkGraph::Suspend(Symbol id) {
  const IdentifierRecord& record = At(id);
  subtree_.push_back(id);
  suspended_[id.index()] = 1 + record.value_of - record.item_of;
}

/// Finds every link from outside into the suspended structure, highest level first, and rescues what it reaches.
void LinkGraph::Rescue() {
  const auto lower = [](const Candidate& a, const Candidate& b) { return a.level > b.level; };
  heap_.clear();
  for (const Symbol member : subtree_) {
    for (LinkId link = At(member).first_link; link != LinkId::kNone; link = link.record->next_in) {
      const Symbol from = link.record->from;
      if (suspended_[from.index()] == 0 && Trace(from, member) == Ancestry::kRooted) {
        heap_.push_back({memory_.level(from), link});
      }
    }
  }
  std::make_heap(heap_.begin(), heap_.end(), lower);
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), lower);
    const Candidate candidate = heap_.back();
    heap_.pop_back();
    const Symbol target = candidate.link.record->to;
    if (suspended_[target.index()] == 0) continue;
    suspended_[target.index()] = 0;
    IdentifierRecord& rescued = At(target);
    if (rescued.parent_link != LinkId::kNone) DropParent(target);
    SetParent(target, candidate.link);
    rescued.level = candidate.level;
    ForEachLinkFrom(target, [&](LinkId link) {
      const Symbol below = link.record->to;
      if (suspended_[below.index()] == 0) return;
      heap_.push_back({candidate.level, link});
      std::push_heap(heap_.begin(), heap_.end(), lower);
    });
  }
}

/// Elements may outlive their preferences until their slot is decided. If such an element does not belong to garbage,
/// its value is rescued with everything that it reaches. Rescued values are checked again when the last of these
/// elements is removed.
void LinkGraph::RescueNamed() {
  const auto for_each_value = [&](Symbol id, auto visit) {
    for (SlotId slot = memory_.identifier(id).slots; slot != SlotId::kNone; slot = memory_.slot(slot).next) {
      for (const WmeId first : {memory_.slot(slot).wmes, memory_.slot(slot).acceptable_wmes}) {
        for (WmeId wme = first; wme != WmeId::kNone; wme = memory_.record(wme).next) {
          const Symbol value = memory_.wme(wme).value;
          if (value.IsIdentifier() && value != id && suspended_[value.index()] != 0) visit(value);
        }
      }
    }
  };
  const auto forget = [&](Symbol value) {
    if (suspended_[value.index()] > 1) --suspended_[value.index()];
  };
  for (const Symbol goal : gone_) for_each_value(goal, forget);
  for (const Symbol member : subtree_) {
    if (suspended_[member.index()] != 0) for_each_value(member, forget);
  }
  stack_.clear();
  for (const Symbol member : subtree_) {
    if (suspended_[member.index()] > 1) stack_.push_back(member);
  }
  while (!stack_.empty()) {
    const Symbol id = stack_.back();
    stack_.pop_back();
    if (suspended_[id.index()] == 0) continue;
    suspended_[id.index()] = 0;
    for_each_value(id, [&](Symbol value) { stack_.push_back(value); });
    ForEachLinkFrom(id, [&](LinkId link) { stack_.push_back(link.record->to); });
  }
}

/// Appends everything that was not rescued: first what the roots reach (reached last, listed first), then the roots.
void LinkGraph::ListGarbage(std::vector<Symbol>& garbage) {
  std::erase_if(roots_, [&](Symbol root) { return suspended_[root.index()] == 0; });
  if (roots_.empty()) return;
  const std::size_t first = garbage.size();
  stack_.assign(roots_.rbegin(), roots_.rend());
  while (!stack_.empty()) {
    const Symbol id = stack_.back();
    stack_.pop_back();
    if (suspended_[id.index()] == 0) continue;
    suspended_[id.index()] = 0;
    At(id).rooted = false;
    garbage.push_back(id);
    ForEachLinkFrom(id, [&](LinkId link) {
      if (suspended_[link.record->to.index()] != 0) stack_.push_back(link.record->to);
    });
  }
  for (const Symbol root : roots_) suspended_[root.index()] = 1;
  std::erase_if(garbage, [&](Symbol id) { return suspended_[id.index()] != 0; });
  std::reverse(garbage.begin() + static_cast<std::ptrdiff_t>(first), garbage.end());
  for (const Symbol root : roots_) {
    suspended_[root.index()] = 0;
    garbage.push_back(root);
  }
}

/// Visits the links of the identifier's preferences and elements.
template <typename Visit>
void LinkGraph::ForEachLinkFrom(Symbol id, Visit visit) const {
  const auto visit_link = [&](LinkId link) {
    if (link != LinkId::kNone) visit(link);
  };
  const auto visit_preferences = [&](PreferenceId first) {
    for (PreferenceId p = first; p != PreferenceId::kNone; p = memory_.preference(p).next_in_slot) {
      visit_link(memory_.preference(p).value_link);
      visit_link(memory_.preference(p).referent_link);
    }
  };
  const auto visit_elements = [&](WmeId first) {
    for (WmeId wme = first; wme != WmeId::kNone; wme = memory_.record(wme).next) visit_link(memory_.record(wme).link);
  };
  const IdentifierRecord& record = memory_.identifier(id);
  for (SlotId slot = record.slots; slot != SlotId::kNone; slot = memory_.slot(slot).next) {
    visit_preferences(memory_.slot(slot).acceptable);
    visit_preferences(memory_.slot(slot).others);
    // Elements that the architecture puts into a slot (^command and ^result of the memories) have no preference.
    if (memory_.slot(slot).acceptable == PreferenceId::kNone) visit_elements(memory_.slot(slot).wmes);
  }
  visit_elements(record.architecture_wmes);
  visit_elements(record.input_wmes);
}

// Clearing and checking -----------------------------------------------------------------------------------------------

void LinkGraph::Clear() {
  links_.Clear();
  promoted_.clear();
  posted_.clear();
  unheld_.clear();
  uncertain_.clear();
  gone_.clear();
  restless_ = settling_ = false;
  suspended_.clear();
}

std::size_t LinkGraph::MemoryBytes() const {
  return links_.MemoryBytes() +
         (promoted_.capacity() + posted_.capacity() + unheld_.capacity() + uncertain_.capacity() + gone_.capacity() +
          roots_.capacity() + subtree_.capacity() + stack_.capacity()) *
             sizeof(Symbol) +
         suspended_.capacity() * sizeof(std::uint32_t) + heap_.capacity() * sizeof(Candidate);
}

std::string LinkGraph::CheckInvariants(const SymbolTable& symbols) const {
  if (HasWork()) return {};
  for (std::uint32_t index = 0; index < memory_.identifier_limit(); ++index) {
    const Symbol id(Symbol::Tag::kIdentifier, index);
    const IdentifierRecord& record = memory_.identifier(id);
    if (!record.live || record.is_goal) continue;
    // An identifier that was not reachable keeps its initial level when a lower state links to it.
    if (record.parent_link != LinkId::kNone && memory_.level(record.parent_link.record->from) < record.level) {
      return "the level of " + ToString(symbols, id) + " is below that of its parent";
    }
    Symbol up = id;
    for (std::uint32_t steps = 0; memory_.identifier(up).parent_link != LinkId::kNone; ++steps) {
      if (steps > memory_.identifier_limit()) return "the parents of " + ToString(symbols, id) + " form a cycle";
      up = memory_.identifier(up).parent_link.record->from;
    }
    if (!memory_.identifier(up).is_goal) continue;
    for (LinkId link = record.first_link; link != LinkId::kNone; link = link.record->next_in) {
      const Symbol from = link.record->from;
      if (memory_.level(from) < record.level && Trace(from, id) == Ancestry::kRooted) {
        return ToString(symbols, id) + " is linked from a higher level but was not promoted";
      }
    }
  }
  return {};
}

}  // namespace soarbox::kernel
