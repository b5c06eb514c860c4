// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/memory/links.h"

#include <algorithm>
#include <string>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

// Adding and removing -------------------------------------------------------------------------------------------------

LinkId LinkGraph::Add(Symbol from, Symbol to) {
  IdentifierRecord& target = At(to);
  if (target.is_goal || from == to) return LinkId::kNone;
  const LinkId id = links_.Take();
  Link& link = *id.record;
  link.from = from;
  link.to = to;
  link.next_in = target.first_link;
  if (target.first_link != LinkId::kNone) target.first_link.record->previous_in = id;
  target.first_link = id;

  const IdentifierRecord& source = At(from);
  if (target.parent_link == LinkId::kNone) {
    // One that has just lost its hold on a higher level finds its new one when links settle: its level falls then.
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

/// The identifier has come to hang on a goal: so does all that it reaches and that floated until now, circles included.
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
  if (target.parent_link == id) {
    DropParent(link.to);
    Queue(link.to);
  } else {
    Touch(link.to);
  }
  if (link.previous_in != LinkId::kNone) {
    link.previous_in.record->next_in = link.next_in;
  } else {
    target.first_link = link.next_in;
  }
  if (link.next_in != LinkId::kNone) link.next_in.record->previous_in = link.previous_in;
  links_.Give(id);
}

void LinkGraph::Queue(Symbol id) {
  IdentifierRecord& record = At(id);
  if (record.queued) return;
  record.queued = true;
  Enqueue(id);
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

Symbol LinkGraph::TopOf(Symbol id) const {
  for (;;) {
    const IdentifierRecord& record = memory_.identifier(id);
    if (record.is_goal || record.parent_link == LinkId::kNone) return id;
    id = record.parent_link.record->from;
  }
}

// Settling ------------------------------------------------------------------------------------------------------------

void LinkGraph::Settle(std::vector<Symbol>& garbage) {
  Work(garbage);
  restless_ = !queue_.empty() || !promoted_.empty() || !uncertain_.empty() || !goals_.empty();
}

inline void LinkGraph::Work(std::vector<Symbol>& garbage) {
  for (const Symbol id : promoted_) Promote(id);
  promoted_.clear();
  while (!queue_.empty()) {
    const Symbol id = queue_.back();
    queue_.pop_back();
    IdentifierRecord& record = At(id);
    if (!record.queued) continue;  // An older entry of one that has had its turn.
    record.queued = false;
    if (!record.live || record.is_goal || record.parent_link != LinkId::kNone) continue;
    if (record.first_link == LinkId::kNone) {
      if (record.value_of != record.item_of) continue;
      if (record.item_of != 0) {  // An item of an impasse counts as a link, but leads nowhere.
        uncertain_.push_back(id);
        continue;
      }
      record.rooted = false;
      garbage.push_back(id);
      return;
    }
    uncertain_.push_back(id);
  }
  if (!goals_.empty()) {
    garbage.push_back(goals_.front());
    goals_.erase(goals_.begin());
    return;
  }
  while (!uncertain_.empty() && garbage.empty()) {
    const Symbol id = uncertain_.back();
    uncertain_.pop_back();
    const IdentifierRecord& record = At(id);
    if (record.live && !record.is_goal && record.parent_link == LinkId::kNone) Reattach(id, garbage);
  }
}

void LinkGraph::ElementRemoved(Symbol value, bool is_item) {
  IdentifierRecord& record = At(value);
  record.item_of -= is_item ? 1 : 0;
  if (--record.value_of != 0 || record.is_goal || record.parent_link != LinkId::kNone ||
      record.first_link != LinkId::kNone)
    return;
  if (record.queued) {
    Enqueue(value);
  } else {
    Queue(value);
  }
}

/// Another link to an identifier that waits has gone: its turn is counted from now.
void LinkGraph::Touch(Symbol id) {
  const IdentifierRecord& record = At(id);
  if (record.queued && record.parent_link == LinkId::kNone) Enqueue(id);
}

/// If a link from a higher level leads to the identifier, gives it and what it reaches that level.
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

/// Finds the identifier a new parent, or takes what only it reaches apart.
void LinkGraph::Reattach(Symbol id, std::vector<Symbol>& garbage) {
  IdentifierRecord& record = At(id);
  for (LinkId link = record.first_link; link != LinkId::kNone; link = link.record->next_in) {
    const Symbol from = link.record->from;
    if (memory_.level(from) == record.level && Trace(from, id) == Ancestry::kRooted) {
      SetParent(id, link);
      return;
    }
  }
  // The tree below hangs in the air: find every link that enters it from outside, highest level first, and grow from
  // there.
  if (suspended_.size() < memory_.identifier_limit()) suspended_.resize(memory_.identifier_limit(), 0);
  subtree_.clear();
  const auto suspend = [&](Symbol member) {
    subtree_.push_back(member);
    suspended_[member.index()] = 1;
  };
  suspend(id);
  for (std::size_t next = 0; next < subtree_.size(); ++next) {
    const IdentifierRecord& member = At(subtree_[next]);
    for (LinkId child = member.first_child; child != LinkId::kNone; child = child.record->next_child) {
      suspend(child.record->to);
    }
    if (uncertain_.empty()) continue;
    // What hangs on another one that waits for its turn must wait with it.
    for (LinkId link = member.first_link; link != LinkId::kNone; link = link.record->next_in) {
      const Symbol top = TopOf(link.record->from);
      if (!memory_.identifier(top).is_goal && suspended_[top.index()] == 0 &&
          std::find(uncertain_.begin(), uncertain_.end(), top) != uncertain_.end()) {
        suspend(top);
      }
    }
  }
  const auto lower = [](const Candidate& a, const Candidate& b) { return a.level > b.level; };
  heap_.clear();
  for (const Symbol member : subtree_) {
    for (LinkId link = At(member).first_link; link != LinkId::kNone; link = link.record->next_in) {
      const Symbol from = link.record->from;
      if (suspended_[from.index()] == 0 && Trace(from, id) == Ancestry::kRooted) {
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
  for (std::size_t n = subtree_.size(); n-- > 0;) {
    const Symbol member = subtree_[n];
    if (suspended_[member.index()] == 0) continue;
    suspended_[member.index()] = 0;
    At(member).rooted = false;
    garbage.push_back(member);
  }
}

/// Visits the links that the identifier's preferences and elements make.
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
    // What the architecture puts into a slot (^command and ^result of the memories) is there without a preference.
    if (memory_.slot(slot).acceptable == PreferenceId::kNone) visit_elements(memory_.slot(slot).wmes);
  }
  visit_elements(record.architecture_wmes);
  visit_elements(record.input_wmes);
}

// The rest ------------------------------------------------------------------------------------------------------------

void LinkGraph::Clear() {
  links_.Clear();
  queue_.clear();
  promoted_.clear();
  goals_.clear();
  uncertain_.clear();
  restless_ = false;
  suspended_.clear();
}

std::size_t LinkGraph::MemoryBytes() const {
  return links_.MemoryBytes() +
         (queue_.capacity() + promoted_.capacity() + uncertain_.capacity() + subtree_.capacity() + stack_.capacity()) *
             sizeof(Symbol) +
         suspended_.capacity() + heap_.capacity() * sizeof(Candidate);
}

std::string LinkGraph::CheckInvariants(const SymbolTable& symbols) const {
  if (HasWork()) return {};
  for (std::uint32_t index = 0; index < memory_.identifier_limit(); ++index) {
    const Symbol id(Symbol::Tag::kIdentifier, index);
    const IdentifierRecord& record = memory_.identifier(id);
    if (!record.live || record.is_goal) continue;
    // One that floated keeps the level that it was made with when a lower state links it.
    if (record.parent_link != LinkId::kNone && memory_.level(record.parent_link.record->from) < record.level) {
      return "the level of " + ToString(symbols, id) + " is below that of its parent";
    }
    Symbol up = id;
    for (std::uint32_t steps = 0; memory_.identifier(up).parent_link != LinkId::kNone; ++steps) {
      if (steps > memory_.identifier_limit())
        return "the parents of " + ToString(symbols, id) + " go round in a circle";
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
